using System;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>A package that a project needs: its source and the supported versions.</summary>
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

        /// <summary>A name or git address for the Package Manager; null if the package needs a scoped registry first.</summary>
        public string Identifier { get; }

        /// <summary>The value in a manifest: a version or an address.</summary>
        public string Reference { get; }

        /// <summary>The scoped registry; null for Unity's own packages, and for packages from an address.</summary>
        public ScopedRegistry Registry { get; }

        /// <summary>Description of the supported versions; null if all are.</summary>
        public string Bounds
        {
            get
            {
                if (_min == null) return _below == null ? null : "older than " + _below;
                return _min + (_below == null ? " or newer" : CheckResults.OrNewer(_below));
            }
        }

        /// <param name="version">The version for a manifest.</param>
        /// <param name="isEditorsChoice">Whether the set-up window leaves the version to the editor, which recommends one.</param>
        public static PackageOrigin OfUnity(
            string name, string version, string min = null, string below = null, bool isEditorsChoice = false) =>
            new PackageOrigin(name, isEditorsChoice ? name : name + "@" + version, version, null, min, below);

        /// <param name="address">An address for the Package Manager: a git address, or file: and a path.</param>
        public static PackageOrigin At(string name, string address, string min = null, string below = null) =>
            new PackageOrigin(name, address, address, null, min, below);

        public static PackageOrigin Of(ScopedRegistry registry, string name, string version, string min = null, string below = null) =>
            new PackageOrigin(name, null, version, registry, min, below);

        /// <summary>Returns whether a version is supported.</summary>
        /// <param name="version">A version, or an address from a manifest.</param>
        /// <returns>Null if the text does not contain the version.</returns>
        public bool? Serves(string version)
        {
            if (version == Reference || (_min == null && _below == null)) return true;
            var parsed = PackageVersion.Read(version);
            if (parsed == null) return null;
            return (_min == null || parsed >= _min) && (_below == null || parsed < _below);
        }

        /// <summary>Returns whether a version is at or above the upper bound.</summary>
        public bool IsTooNew(string version) => _below != null && PackageVersion.Read(version) is Version parsed && parsed >= _below;
    }
}
