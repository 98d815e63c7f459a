namespace Nowpose.Editor
{
    /// <summary>Where a package comes from.</summary>
    sealed class PackageOrigin
    {
        PackageOrigin(string name, string identifier, string version, ScopedRegistry registry)
        {
            Name = name;
            Identifier = identifier;
            Version = version;
            Registry = registry;
        }

        public string Name { get; }

        /// <summary>A name or git URL that the Package Manager takes as it is; null where a registry has to be added for it.</summary>
        public string Identifier { get; }

        public string Version { get; }
        public ScopedRegistry Registry { get; }

        /// <param name="version">Null for the one that Unity recommends for this editor.</param>
        public static PackageOrigin OfUnity(string name, string version = null) =>
            new PackageOrigin(name, version == null ? name : name + "@" + version, version, null);

        public static PackageOrigin OfGit(string name, string url) => new PackageOrigin(name, url, null, null);

        public static PackageOrigin Of(ScopedRegistry registry, string name, string version) => new PackageOrigin(name, null, version, registry);
    }
}
