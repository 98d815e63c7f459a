using System;

namespace Nowpose.Editor
{
    /// <summary>Compares versions of packages; a preview counts as its release.</summary>
    static class PackageVersion
    {
        public static bool IsAtLeast(string version, Version least) => Version.TryParse(version.Split('-')[0], out var parsed) && parsed >= least;
    }
}
