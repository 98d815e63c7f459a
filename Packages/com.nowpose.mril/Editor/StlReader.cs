using System;
using System.IO;
using Nowpose.Editor.Import;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor
{
    /// <summary>Reads meshes in the binary and the ASCII STL format, which Unity does not import.</summary>
    /// <remarks>The file length decides between the formats, not the first word: many exporters begin binary files with "solid" too.</remarks>
    public static class StlReader
    {
        /// <summary>Maximum number of triangles: as many as a headset can still draw, and more than any robot link needs.</summary>
        public const int MaxTriangles = 1_000_000;

        [Obsolete("use MaxTriangles")]
        public const int MostTriangles = MaxTriangles;

        /// <summary>Maximum file size in bytes, 300 MiB: a triangle takes about 270 bytes as text.</summary>
        public const long MaxFileBytes = 300L << 20;

        /// <inheritdoc cref="MaxFileBytes"/>
        [Obsolete("use MaxFileBytes")]
        public const long LargestFile = MaxFileBytes;

        /// <param name="path">Path of the file.</param>
        /// <param name="sourceName">The name of the file in error messages.</param>
        /// <exception cref="Nowpose.InputException">The STL file cannot be used. The message names the file, the line or byte, and the error.</exception>
        /// <exception cref="IOException">The file cannot be read.</exception>
        public static StlTriangles ReadFile(string path, string sourceName)
        {
            var length = new FileInfo(path).Length;
            if (length > MaxFileBytes)
                throw new InputException(StlMessages.FileTooLong(sourceName, length, MaxFileBytes));
            return Read(File.ReadAllBytes(path), sourceName);
        }

        /// <inheritdoc cref="ReadFile"/>
        /// <param name="content">The whole file.</param>
        public static StlTriangles Read(byte[] content, string sourceName)
        {
            var triangles = StlBinary.Recognises(content) ? StlBinary.Read(content, sourceName) : StlText.Read(content, sourceName);
            if (triangles.Count > 0) return triangles;
            throw new InputException(sourceName + ": " + (triangles.Degenerate == 0
                ? StlMessages.NoTriangles
                : StlMessages.NoArea(triangles.Degenerate)));
        }

        internal static InputException TooMany(string where, long count) =>
            new InputException(StlMessages.TooMany(where, count, MaxTriangles));
    }
}
