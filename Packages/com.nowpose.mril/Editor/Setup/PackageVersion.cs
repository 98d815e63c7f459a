using System;
using System.Text.RegularExpressions;

namespace Nowpose.Editor.Setup
{
    /// <summary>Reads the version of a package. Ignores the suffix of a preview version, so that 1.2.0-pre.3 is read as 1.2.0.</summary>
    static class PackageVersion
    {
        static readonly Regex Plain = new Regex(@"^\d+\.\d+\.\d+(-[\w.-]+)?$", RegexOptions.CultureInvariant);

        // Matches a tag such as #core-v3.3.0 at the end of a Git URL, or the name of a tarball such as org.example.core-3.3.0.tgz.
        static readonly Regex InAddress = new Regex(
            @"(?:#(?:[^#]*[-/])?v?(\d+\.\d+\.\d+)(?:-[\w.-]+)?$)|(?:-(\d+\.\d+\.\d+)(?:-[\w.]+)?\.tgz$)", RegexOptions.CultureInvariant);

        /// <summary>Reads the version from the value of a dependency: a version, a Git URL with a tag, or the name of a tarball.</summary>
        /// <returns>
        /// Null if the value does not contain a version, for example because it is the path of a folder or a Git URL with a commit.
        /// </returns>
        public static Version Read(string reference)
        {
            if (Plain.IsMatch(reference)) return Version.TryParse(reference.Split('-')[0], out var plain) ? plain : null;
            var match = InAddress.Match(reference);
            if (!match.Success) return null;
            return Version.TryParse(match.Groups[1].Success ? match.Groups[1].Value : match.Groups[2].Value, out var parsed) ? parsed : null;
        }
    }
}
