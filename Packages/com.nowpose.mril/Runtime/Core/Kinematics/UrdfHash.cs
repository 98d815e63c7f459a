using System;
using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace Nowpose.Kinematics
{
    /// <summary>SHA-256 of a URDF, independent of how the URDF was transferred.</summary>
    /// <remarks>
    /// It ignores the kind of line endings, a byte order mark and white space around the document, because editors, version control and publishers
    /// change them. All other characters affect the hash, including those of comments. <c>default</c> stands for a missing URDF.
    /// </remarks>
    readonly struct UrdfHash : IEquatable<UrdfHash>
    {
        readonly string _hex;

        UrdfHash(string hex) => _hex = hex;

        public static UrdfHash Of(string text)
        {
            var normal = text.TrimStart('\uFEFF').Replace("\r\n", "\n").Replace('\r', '\n').Trim();
            using (var sha = SHA256.Create())
                return new UrdfHash(Hex(sha.ComputeHash(Encoding.UTF8.GetBytes(normal))));
        }

        public static bool operator ==(UrdfHash a, UrdfHash b) => a._hex == b._hex;
        public static bool operator !=(UrdfHash a, UrdfHash b) => !(a == b);

        public bool Equals(UrdfHash other) => this == other;
        public override bool Equals(object obj) => obj is UrdfHash other && Equals(other);
        public override int GetHashCode() => _hex == null ? 0 : StringComparer.Ordinal.GetHashCode(_hex);

        /// <summary>Returns the hash as 64 hexadecimal digits in lower case; empty for <c>default</c>.</summary>
        public override string ToString() => _hex ?? "";

        static string Hex(byte[] bytes)
        {
            var text = new StringBuilder(2 * bytes.Length);
            foreach (var b in bytes) text.Append(b.ToString("x2", CultureInfo.InvariantCulture));
            return text.ToString();
        }
    }
}
