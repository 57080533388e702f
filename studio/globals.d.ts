/* What the bundle is given: three.js as one global, the version. */
declare const THREE: any;
declare const VERSION: string;
/* What TypeScript 4.8 does not know of browsers. */
declare class CompressionStream extends TransformStream<any, any> { constructor(format: string); }
declare class DecompressionStream extends TransformStream<any, any> { constructor(format: string); }
