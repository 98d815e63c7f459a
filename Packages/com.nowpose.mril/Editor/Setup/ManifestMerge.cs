using System;
using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Merges requirements into the text of a project's Packages/manifest.json. Keeps valid entries and the formatting.</summary>
    sealed class ManifestMerge
    {
        const string Dependencies = "dependencies", Registries = "scopedRegistries", Testables = "testables";

        readonly ManifestText _manifest;
        readonly ConflictRule _rule, _registryRule;
        readonly List<string> _changes = new List<string>();
        readonly List<string> _conflicts = new List<string>();
        readonly List<string> _notes = new List<string>();

        /// <param name="file">Name of the file in messages.</param>
        /// <param name="rule">Action for entries that do not meet a requirement.</param>
        /// <param name="registryRule">Action for registries from which a package is taken instead of its own; null for the same action.</param>
        /// <exception cref="InputException">The text is not a manifest.</exception>
        public ManifestMerge(string text, string file, ConflictRule rule, ConflictRule? registryRule = null)
        {
            _manifest = new ManifestText(text, file);
            _rule = rule;
            _registryRule = registryRule ?? rule;
        }

        public string Text => _manifest.Text;

        /// <summary>Descriptions of the additions and replacements.</summary>
        public IReadOnlyList<string> Changes => _changes;

        /// <summary>Descriptions, with line numbers, of the entries that do not meet a requirement and were not replaced.</summary>
        /// <remarks>With <see cref="ConflictRule.Refuse"/>, <see cref="Text"/> must not be used if there are conflicts.</remarks>
        public IReadOnlyList<string> Conflicts => _conflicts;

        /// <summary>Whether <see cref="ConflictRule.Replace"/> would resolve all conflicts.</summary>
        public bool CanReplaceAll { get; private set; } = true;

        /// <summary>Descriptions of the entries that were kept because their version cannot be read.</summary>
        public IReadOnlyList<string> Notes => _notes;

        /// <summary>
        /// Returns the value of a dependency, which is a version or an address; null if the manifest does not contain the dependency.
        /// </summary>
        /// <exception cref="InputException">The text is not a manifest.</exception>
        public string VersionOf(string package)
        {
            var entry = _manifest.Find(Dependencies, isObject: true)?[package];
            return entry == null ? null : StringOf(entry, package);
        }

        /// <summary>Adds a dependency and its registry if they are missing. Otherwise checks whether the entries meet the requirement.</summary>
        /// <param name="isExact">Whether only the version or address of <paramref name="package"/> meets the requirement.</param>
        /// <exception cref="InputException">The text is not a manifest.</exception>
        public void Need(PackageOrigin package, bool isExact = false)
        {
            if (package.Registry != null && !NeedRegistry(package)) return;
            var entry = _manifest.Find(Dependencies, isObject: true)?[package.Name];
            if (entry == null) AddDependency(package);
            else Judge(package, entry, StringOf(entry, package.Name), isExact);
        }

        /// <summary>Adds a package to the list of packages whose tests Unity's Test Runner shows.</summary>
        /// <exception cref="InputException">The text is not a manifest.</exception>
        public void NeedTestable(string package)
        {
            var all = _manifest.Find(Testables, isObject: false);
            if (all != null && all.Items.Any(item => item.Text == package)) return;
            if (all == null) _manifest.Add(Testables, new JArray(package));
            else _manifest.Add(all, null, package);
            _changes.Add(Testables + ": " + package);
        }

        void AddDependency(PackageOrigin package)
        {
            var all = _manifest.Find(Dependencies, isObject: true);
            if (all == null) _manifest.Add(Dependencies, new JObject { [package.Name] = package.Reference });
            else _manifest.Add(all, package.Name, package.Reference);
            _changes.Add(Dependencies + ": " + package.Name + " " + package.Reference);
        }

        void Judge(PackageOrigin package, JsonOutline entry, string version, bool isExact)
        {
            if (version == package.Reference) return;
            var serves = isExact ? false : package.Serves(version);
            if (serves == true) return;
            if (serves == null)
            {
                _notes.Add(ManifestMessages.VersionUnreadable(package.Name, version, package.Bounds));
                return;
            }
            var needed = isExact ? package.Reference : package.Bounds;
            var conflict = ManifestMessages.OtherVersion(_manifest.PlaceOf(entry), package.Name, version, needed);
            if (_rule != ConflictRule.Replace)
            {
                _conflicts.Add(conflict);
                return;
            }
            _manifest.Replace(entry, package.Reference);
            _changes.Add(Dependencies + ": " + package.Name + " " + package.Reference + " in place of " + version);
        }

        // Adds or checks the registry of a package. Returns false if the package comes from another registry that must be kept.
        bool NeedRegistry(PackageOrigin package)
        {
            var registry = package.Registry;
            var other = RegistryOf(package.Name);
            if (other != null && !registry.Is(UrlOf(other))) return TakeOver(package, other);
            if (other == null) other = Items(Registries).FirstOrDefault(item => registry.Is(UrlOf(item)));
            if (other == null) AddRegistry(registry);
            else AddScopes(registry, other);
            return true;
        }

        bool TakeOver(PackageOrigin package, JsonOutline other)
        {
            var url = UrlOf(other);
            var scopes = ScopesOf(other).ToList();
            var isReplaceable = url != null && scopes.All(scope => package.Registry.Scopes.Contains(scope));
            if (_registryRule == ConflictRule.Replace && isReplaceable)
            {
                _manifest.Replace(other["url"], package.Registry.Url);
                _changes.Add(Registries + ": " + package.Registry.Url + " in place of " + url);
                return true;
            }
            _conflicts.Add(ManifestMessages.OtherRegistry(_manifest.PlaceOf(other), package.Name, url, package.Registry.Url, !isReplaceable));
            CanReplaceAll &= isReplaceable;
            return _registryRule == ConflictRule.Keep;
        }

        void AddRegistry(ScopedRegistry registry)
        {
            var entry = new JObject { ["name"] = registry.Name, ["url"] = registry.Url, ["scopes"] = new JArray(registry.Scopes) };
            var all = _manifest.Find(Registries, isObject: false);
            if (all == null) _manifest.Add(Registries, new JArray(entry));
            else _manifest.Add(all, null, entry);
            _changes.Add(Registries + ": " + registry.Url + " for " + string.Join(", ", registry.Scopes));
        }

        void AddScopes(ScopedRegistry registry, JsonOutline entry)
        {
            var start = entry.Start;
            foreach (var scope in registry.Scopes)
            {
                // Finds the registry again after each change, because a change makes the outlines invalid. Insertions come after the start of the
                // registry, so its start stays valid.
                var now = Items(Registries).First(item => item.Start == start);
                if (ScopesOf(now).Contains(scope)) continue;
                if (now["scopes"] == null) _manifest.Add(now, "scopes", new JArray(scope));
                else _manifest.Add(now["scopes"], null, scope);
                _changes.Add(Registries + ": " + registry.Url + " for " + scope);
            }
        }

        // Returns the registry from which Unity takes a package: the registry with the longest scope that is a prefix of the package's name.
        JsonOutline RegistryOf(string package)
        {
            return Items(Registries)
                .SelectMany(registry => ScopesOf(registry).Select(scope => (Registry: registry, Scope: scope)))
                .Where(pair => package == pair.Scope || package.StartsWith(pair.Scope + ".", StringComparison.Ordinal))
                .OrderByDescending(pair => pair.Scope.Length).Select(pair => pair.Registry).FirstOrDefault();
        }

        IEnumerable<JsonOutline> Items(string name) =>
            _manifest.Find(name, isObject: false)?.Items ?? Enumerable.Empty<JsonOutline>();

        static string UrlOf(JsonOutline registry) => registry["url"]?.Text;

        IEnumerable<string> ScopesOf(JsonOutline registry)
        {
            var scopes = registry["scopes"];
            if (scopes == null) return Enumerable.Empty<string>();
            if (!scopes.IsArray) throw new InputException(ManifestMessages.Scopes(_manifest.PlaceOf(scopes)));
            return scopes.Items.Select(item => item.Text).Where(text => text != null);
        }

        string StringOf(JsonOutline entry, string name) =>
            entry.Text ?? throw new InputException(ManifestMessages.NotAString(_manifest.PlaceOf(entry), name));
    }
}
