using System;
using System.Globalization;
using System.IO;
using System.Text;
using System.Xml;

namespace Nowpose.Editor.Import
{
    /// <summary>Reads the up axis from the header of a model file.</summary>
    /// <remarks>
    /// Unity rotates a model according to this axis but does not report it. A file that does not specify it is Y-up, both in Unity and according to
    /// the file formats.
    /// </remarks>
    static class ModelHeader
    {
        // Number of bytes that are searched. The up axis is in the first section of the file, but a thumbnail may precede it.
        const int Searched = 1 << 20;
        const int MaxProperties = 8;

        /// <summary>Returns the up axis of a file.</summary>
        /// <param name="path">Path of a .dae, .fbx or .obj file.</param>
        public static UpAxis UpAxisOf(string path)
        {
            using (var file = File.OpenRead(path)) return UpAxisOf(file, Path.GetExtension(path));
        }

        public static UpAxis UpAxisOf(Stream content, string extension)
        {
            if (extension.Equals(".dae", StringComparison.OrdinalIgnoreCase)) return OfCollada(content);
            if (extension.Equals(".fbx", StringComparison.OrdinalIgnoreCase)) return OfFbx(Beginning(content));
            return UpAxis.Y;
        }

        static UpAxis OfCollada(Stream content)
        {
            var settings = new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null };
            try
            {
                using (var reader = XmlReader.Create(content, settings))
                {
                    if (!reader.ReadToFollowing("asset")) return UpAxis.Y;
                    using (var asset = reader.ReadSubtree())
                        return asset.ReadToFollowing("up_axis") ? OfColladaName(asset.ReadElementContentAsString()) : UpAxis.Y;
                }
            }
            catch (XmlException)
            {
                // Ignores the error: Unity cannot read the file either, and Unity's model importer logs the error.
                return UpAxis.Y;
            }
        }

        static UpAxis OfColladaName(string name)
        {
            switch (name.Trim())
            {
                case "X_UP": return UpAxis.X;
                case "Z_UP": return UpAxis.Z;
                default: return UpAxis.Y;
            }
        }

        static byte[] Beginning(Stream content)
        {
            var bytes = new byte[Searched];
            var length = 0;
            for (int read; length < bytes.Length && (read = content.Read(bytes, length, bytes.Length - length)) > 0;) length += read;
            Array.Resize(ref bytes, length);
            return bytes;
        }

        static UpAxis OfFbx(byte[] bytes)
        {
            switch (BinaryUpAxis(bytes) ?? TextUpAxis(bytes))
            {
                case 0: return UpAxis.X;
                case 2: return UpAxis.Z;
                default: return UpAxis.Y;
            }
        }

        // Reads the properties of a node, which follow one another. A string consists of 'S', its length and its characters; an integer of 'I' and
        // four bytes.
        static int? BinaryUpAxis(byte[] bytes)
        {
            var at = bytes.AsSpan().IndexOf(Encoding.ASCII.GetBytes("S\u0006\0\0\0UpAxis"));
            for (var i = 0; at >= 0 && at + 5 <= bytes.Length && i < MaxProperties; i++)
            {
                var number = BitConverter.ToInt32(bytes, at + 1);
                if (bytes[at] == 'I') return number;
                if (bytes[at] != 'S' || number < 0 || number > bytes.Length) return null;
                at += 5 + number;
            }
            return null;
        }

        // Example of the line to read: P: "UpAxis", "int", "Integer", "",1
        static int? TextUpAxis(byte[] bytes)
        {
            var text = Encoding.ASCII.GetString(bytes);
            var at = text.IndexOf("\"UpAxis\"", StringComparison.Ordinal);
            if (at < 0) return null;
            var end = text.IndexOf('\n', at);
            var line = end < 0 ? text.Substring(at) : text.Substring(at, end - at);
            var last = line.Substring(line.LastIndexOf(',') + 1);
            return int.TryParse(last, NumberStyles.Integer, CultureInfo.InvariantCulture, out var axis) ? axis : (int?)null;
        }
    }
}
