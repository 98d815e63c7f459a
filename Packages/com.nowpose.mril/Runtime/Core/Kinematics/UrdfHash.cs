using System;
using System.Security.Cryptography;
using System.Text;

namespace Nowpose.Kinematics
{
    /// <summary>SHA-256 of a URDF, independent of how the URDF was transferred.</summary>
    /// <remarks>
    /// It ignores the kind of line endings, a byte order mark and white space around the document, because editors, version control and publishers
    /// change them. All other characters affect the hash, including those of comments.
    /// </remarks>
    static class UrdfHash
    {
        /// <returns>64 hexadecimal digits in lower case.</returns>
        public static string Of(string text)
        {
            var normal = text.TrimStart('\uFEFF').Replace("\r\n", "\n").Replace('\r', '\n').Trim();
            using (var sha = SHA256.Create())
                return BitConverter.ToString(sha.ComputeHash(Encoding.UTF8.GetBytes(normal))).Replace("-", "").ToLowerInvariant();
        }
    }
}
