# Untested: see packaging/README.md. Installs a clone: `brew install --HEAD`.
class Taut < Formula
  desc "Surfaces drawn tight across their boundaries, each with a certificate"
  version "0.2.0"
  license "MIT"
  head "file://#{File.expand_path("../..", __dir__)}", using: :git

  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "pkg-config" => :build
  depends_on "cairo"
  depends_on "flint"
  depends_on :linux

  def install
    system "cmake", "-S", ".", "-B", "build/brew", "-G", "Ninja", "-DBUILD_TESTING=OFF", *std_cmake_args
    system "cmake", "--build", "build/brew", "--target", "product"
    system "cmake", "--install", "build/brew"
  end

  test do
    (testpath/"tent.json").write shell_output("#{bin}/taut example dirichlet-tent")
    system bin/"taut", "make", "tent.json", "--quiet", "-o", "tent.step", "-o", "tent.png"
    assert_predicate testpath/"tent.step", :exist?
  end
end
