using System;
using System.IO;
using Nowpose.Editor.Import;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor
{
    /// <summary>Reads meshes in the binary and in the ASCII STL format. Unity itself imports neither.</summary>
    /// <remarks>
    /// The length of the file determines its format. The first word cannot, because many exporters also start binary files with "solid".
    /// </remarks>
    public static class StlReader
    {
        /// <summary>Maximum number of triangles. A headset can still draw this number, and no robot link needs more.</summary>
        public const int MaxTriangles = 1_000_000;

        [Obsolete("use MaxTriangles")]
        public const int MostTriangles = MaxTriangles;

        /// <summary>Maximum file size in bytes (300 MiB). A triangle needs about 270 bytes in ASCII STL.</summary>
        public const long MaxFileBytes = 300L << 20;

        /// <inheritdoc cref="MaxFileBytes"/>
        [Obsolete("use MaxFileBytes")]
        public const long LargestFile = MaxFileBytes;

        /// <summary>Reads an STL file.</summary>
        /// <param name="path">Path of the file.</param>
        /// <param name="sourceName">Name of the file in error messages.</param>
        /// <exception cref="Nowpose.InputException">
        /// The file is not a valid STL file. The message names the file, the line or byte, and the error.
        /// </exception>
        /// <exception cref="IOException">The file cannot be read.</exception>
        public static StlTriangles ReadFile(string path, string sourceName)
        {
            var length = new FileInfo(path).Length;
            if (length > MaxFileBytes)
                throw new InputException(StlMessages.FileTooLong(sourceName, length, MaxFileBytes));
            return Read(File.ReadAllBytes(path), sourceName);
        }

        /// <summary>Reads an STL file from memory.</summary>
        /// <param name="content">Content of the whole file.</param>
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
