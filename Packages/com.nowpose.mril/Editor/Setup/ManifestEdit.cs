using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Nowpose.Editor
{
    /// <summary>Adds a package of a scoped registry to the text of a project's Packages/manifest.json.</summary>
    static class ManifestEdit
    {
        /// <exception cref="InputException">The text is no manifest.</exception>
        public static string Add(string manifest, PackageOrigin package)
        {
            var root = Parse(manifest);
            ObjectIn(root, "dependencies")[package.Name] = package.Version;
            AddScope(ArrayIn(root, "scopedRegistries"), package.Registry);
            return Written(root);
        }

        static JObject Parse(string manifest)
        {
            try
            {
                return JObject.Parse(manifest);
            }
            catch (JsonReaderException e)
            {
                throw new InputException("Packages/manifest.json:" + e.LineNumber + ": not a JSON object; " + e.Message, e);
            }
        }

        static JObject ObjectIn(JObject root, string name)
        {
            if (root[name] == null) root[name] = new JObject();
            return root[name] as JObject ?? throw new InputException("Packages/manifest.json: " + name + " is no object");
        }

        static JArray ArrayIn(JObject root, string name)
        {
            if (root[name] == null) root[name] = new JArray();
            return root[name] as JArray ?? throw new InputException("Packages/manifest.json: " + name + " is no array");
        }

        static void AddScope(JArray registries, ScopedRegistry registry)
        {
            var known = registries.OfType<JObject>().FirstOrDefault(r => IsSame((string)r["url"], registry.Url));
            if (known == null)
            {
                known = new JObject { ["name"] = registry.Name, ["url"] = registry.Url };
                registries.Add(known);
            }
            var scopes = ArrayIn(known, "scopes");
            if (!scopes.Any(s => (string)s == registry.Scope)) scopes.Add(registry.Scope);
        }

        static bool IsSame(string a, string b) => a != null && a.TrimEnd('/') == b.TrimEnd('/');

        // As Unity writes it: two blanks, LF.
        static string Written(JObject root)
        {
            var text = new StringWriter { NewLine = "\n" };
            using (var writer = new JsonTextWriter(text) { Formatting = Formatting.Indented, Indentation = 2 }) root.WriteTo(writer);
            return text + "\n";
        }
    }
}
