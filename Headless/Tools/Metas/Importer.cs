namespace Nowpose.Metas;

/// <summary>The importer block of a .meta file: name of the importer, and the fields that Unity writes for it.</summary>
public sealed record Importer(string Name, params string[] Fields)
{
    const string NoExternalObjects = "externalObjects: {}";

    /// <summary>GUID of the package's UrdfImporter.cs, the script that imports .urdf files.</summary>
    public const string UrdfImporterGuid = "3a22306441ecdd92ccca08f85b8cecd8";

    static readonly Importer Default = new("DefaultImporter", NoExternalObjects);
    static readonly Importer Manifest = new("PackageManifestImporter", NoExternalObjects);
    static readonly Importer Text = new("TextScriptImporter", NoExternalObjects);

    static readonly Dictionary<string, Importer> ByExtension = new(StringComparer.OrdinalIgnoreCase)
    {
        [".cs"] = new("MonoImporter", NoExternalObjects, "serializedVersion: 2", "defaultReferences: []", "executionOrder: 0",
            "icon: {instanceID: 0}"),
        [".asmdef"] = new("AssemblyDefinitionImporter", NoExternalObjects),
        [".md"] = Text,
        [".txt"] = Text,
        [".json"] = Text,
        [".xml"] = Text,
        [".csv"] = Text,
        [".bytes"] = Text,
        [".urdf"] = new("ScriptedImporter", "internalIDToNameTable: []", NoExternalObjects, "serializedVersion: 2",
            $"script: {{fileID: 11500000, guid: {UrdfImporterGuid}, type: 3}}"),
        [".prefab"] = new("PrefabImporter", NoExternalObjects),
        [".asset"] = new("NativeFormatImporter", NoExternalObjects, "mainObjectFileID: 11400000"),
        [".mat"] = new("NativeFormatImporter", NoExternalObjects, "mainObjectFileID: 2100000"),
        [".shader"] = new("ShaderImporter", NoExternalObjects, "defaultTextures: []", "nonModifiableTextures: []",
            "preprocessorOverride: 0"),
        [".hlsl"] = new("ShaderIncludeImporter", NoExternalObjects),
    };

    /// <summary>Gets the importer that Unity uses for an asset. For folders, scenes and unknown types, it is <c>DefaultImporter</c>.</summary>
    public static Importer For(AssetEntry asset)
    {
        if (asset.IsFolder) return Default;
        if (Path.GetFileName(asset.Path) == "package.json") return Manifest;
        return ByExtension.GetValueOrDefault(Path.GetExtension(asset.Path), Default);
    }
}
