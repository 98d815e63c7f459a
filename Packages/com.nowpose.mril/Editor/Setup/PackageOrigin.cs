using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>A package that a project needs, with its source and its supported versions.</summary>
    sealed class PackageOrigin
    {
        readonly Version _min, _below;

        PackageOrigin(string name, string identifier, string reference, ScopedRegistry registry, string min, string below)
        {
            Name = name;
            Identifier = identifier;
            Reference = reference;
            Registry = registry;
            _min = min == null ? null : Version.Parse(min);
            _below = below == null ? null : Version.Parse(below);
        }

        public string Name { get; }

        /// <summary>Name or URL to pass to the Package Manager; null if the project must first add a scoped registry for the package.</summary>
        public string Identifier { get; }

        /// <summary>Value of the dependency in a manifest: a version or a URL.</summary>
        public string Reference { get; }

        /// <summary>Scoped registry of the package; null for Unity's own packages and for packages that are installed from a URL.</summary>
        public ScopedRegistry Registry { get; }

        /// <summary>Description of the supported versions; null if all versions are supported.</summary>
        public string Bounds
        {
            get
            {
                if (_min == null) return _below == null ? null : "older than " + _below;
                return _min + (_below == null ? " or newer" : CheckResults.OrNewer(_below));
            }
        }

        /// <summary>Creates the origin of a package from Unity's registry.</summary>
        /// <param name="version">Version to write into a manifest.</param>
        /// <param name="min">Oldest supported version; null without a lower bound.</param>
        /// <param name="below">First version that is no longer supported; null without an upper bound.</param>
        /// <param name="isEditorsChoice">
        /// Whether the set-up window adds the version that the editor recommends instead of <paramref name="version"/>.
        /// </param>
        public static PackageOrigin OfUnity(
            string name, string version, string min = null, string below = null, bool isEditorsChoice = false) =>
            new PackageOrigin(name, isEditorsChoice ? name : name + "@" + version, version, null, min, below);

        /// <summary>Creates the origin of a package that is installed from a URL.</summary>
        /// <param name="url">URL for the Package Manager: a Git URL, or file: and a path.</param>
        public static PackageOrigin At(string name, string url, string min = null, string below = null) =>
            new PackageOrigin(name, url, url, null, min, below);

        public static PackageOrigin Of(ScopedRegistry registry, string name, string version, string min = null, string below = null) =>
            new PackageOrigin(name, null, version, registry, min, below);

        /// <summary>Returns whether a version is supported.</summary>
        /// <param name="version">A version or a URL, as in a manifest.</param>
        /// <returns>
        /// Null if the answer is unknown: the supported versions are limited, and the value contains no version and differs from
        /// <see cref="Reference"/>.
        /// </returns>
        public bool? Serves(string version)
        {
            if (version == Reference || (_min == null && _below == null)) return true;
            var parsed = PackageVersion.Read(version);
            if (parsed == null) return null;
            return (_min == null || parsed >= _min) && (_below == null || parsed < _below);
        }

        /// <summary>Returns whether a version is too new to be supported.</summary>
        public bool IsTooNew(string version) => _below != null && PackageVersion.Read(version) is Version parsed && parsed >= _below;
    }
}
