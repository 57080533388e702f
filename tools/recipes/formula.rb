# formula.rb RECIPE PREFIX FOLDER -- Homebrew's words, as far as packaging/homebrew says them: installs into PREFIX from here, then runs
# the recipe's test in FOLDER.
require "pathname"

class Formula
  PLATFORMS = [:linux].freeze

  class << self
    attr_reader :depends, :checks

    %i[desc version license].each do |word|
      define_method(word) { |text| text.is_a?(String) && !text.empty? or raise "#{word}: #{text.inspect}" }
    end

    def head(url, using:)
      folder = url.delete_prefix("file://")
      using == :git && File.exist?("#{folder}/CMakeLists.txt") or raise "head: no tree at #{url}"
    end

    def depends_on(what)
      name = what.is_a?(Hash) ? what.keys.first : what
      name.is_a?(String) || PLATFORMS.include?(name) or raise "depends_on: #{what.inspect}"
      (@depends ||= []) << name
    end

    def test(&block)
      @checks = block
    end
  end

  def initialize(prefix, folder)
    @prefix = Pathname.new(prefix)
    @folder = Pathname.new(folder)
  end

  def std_cmake_args
    ["-DCMAKE_INSTALL_PREFIX=#{@prefix}", "-DCMAKE_INSTALL_LIBDIR=lib", "-DCMAKE_BUILD_TYPE=Release"]
  end

  def bin
    @prefix/"bin"
  end

  def testpath
    @folder
  end

  def system(*words)
    Kernel.system(*words.map(&:to_s)) or raise "failed: #{words.join(" ")}"
  end

  def shell_output(command)
    said = `#{command}`
    $?.success? or raise "failed: #{command}"
    said
  end

  def assert_predicate(what, predicate)
    what.send(predicate) or raise "not #{predicate} #{what}"
  end

  def run_checks
    ENV["LD_LIBRARY_PATH"] = (@prefix/"lib").to_s
    Dir.chdir(@folder) { instance_eval(&self.class.checks) }
  end
end

# What Homebrew adds to paths.
class Pathname
  def write(text)
    File.write(self, text)
  end
end

recipe, prefix, folder = ARGV
load File.expand_path(recipe)
formula = Taut.new(prefix, folder)
formula.install
formula.run_checks
