using System;
using System.Buffers.Binary;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Import
{
    /// <summary>Reads binary STL: 80 arbitrary bytes, the number of triangles, and 50 bytes per triangle, all little-endian.</summary>
    static class StlBinary
    {
        const int Header = 80;
        const int Start = 84;
        const int Stride = 50;

        // Number of bytes of the normal, which precedes the corners. The normal is not read, because many exporters write a zero or wrong normal.
        const int Normal = 12;

        /// <summary>
        /// Returns whether a file is binary: its length fits the number of triangles, or (in case the file is truncated) its content cannot be text.
        /// </summary>
        public static bool Recognises(byte[] content)
        {
            if (content.Length >= Start && content.Length == LengthFor(Count(content))) return true;
            return !StlText.Begins(content) || Array.IndexOf(content, (byte)0, 0, Math.Min(content.Length, Start)) >= 0;
        }

        public static StlTriangles Read(byte[] content, string sourceName)
        {
            if (content.Length < Start)
                throw new InputException(StlMessages.HeaderCut(sourceName, content.Length, Start));
            var count = Count(content);
            if (count > StlReader.MaxTriangles) throw StlReader.TooMany(sourceName + ", byte " + Header, count);
            if (content.Length != LengthFor(count))
                throw new InputException(StlMessages.OtherLength(sourceName, Header, count, LengthFor(count), content.Length));

            var triangles = new StlTriangles();
            var corners = new float[9];
            for (var at = Start; at < content.Length; at += Stride)
            {
                for (var i = 0; i < corners.Length; i++) corners[i] = Number(content, at + Normal + 4 * i, sourceName);
                triangles.Add(corners);
            }
            return triangles;
        }

        static uint Count(byte[] content) => BinaryPrimitives.ReadUInt32LittleEndian(content.AsSpan(Header));

        static long LengthFor(uint count) => Start + (long)Stride * count;

        static float Number(byte[] content, int at, string sourceName)
        {
            var number = BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(content.AsSpan(at)));
            if (float.IsNaN(number) || float.IsInfinity(number))
                throw new InputException(StlMessages.NotFinite(sourceName, at, (at - Start) / Stride + 1));
            return number;
        }
    }
}
