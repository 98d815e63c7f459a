namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>
/// A reference to an object: <c>{fileID: N}</c> to an object in the same file, <c>{fileID: N, guid: G, type: T}</c> to an object in another file.
/// </summary>
/// <param name="FileId">FileID of the object.</param>
/// <param name="Guid">GUID of the other file, as 32 hexadecimal digits; null for an object in the same file.</param>
/// <param name="Type">Type number of the other file; 0 for an object in the same file.</param>
readonly record struct AssetReference(long FileId, string Guid = null, int Type = 0)
{
    /// <summary>Type number for Unity's built-in assets.</summary>
    public const int BuiltIn = 0;

    /// <summary>Type number for assets in Unity's own format, for example materials and ScriptableObjects.</summary>
    public const int Native = 2;

    /// <summary>Type number for the result of an importer, for example scripts, prefabs and shaders.</summary>
    public const int Imported = 3;

    public static AssetReference None => default;

    public bool IsNone => FileId == 0 && Guid == null;

    /// <summary>Reads a reference. Returns false if the node does not have exactly one of the two forms.</summary>
    public static bool TryRead(YamlNode node, out AssetReference reference)
    {
        reference = default;
        if (!(node is YamlMappingNode mapping) || !TryReadNumber(mapping, "fileID", out var fileId)) return false;
        if (mapping.Children.Count == 1)
        {
            reference = new AssetReference(fileId);
            return true;
        }
        if (mapping.Children.Count != 3 || !TryReadNumber(mapping, "type", out var type)) return false;
        if (!(Nodes.Find(mapping, "guid") is YamlScalarNode guid) || guid.Value.Length != 32 || fileId == 0) return false;
        reference = new AssetReference(fileId, guid.Value, (int)type);
        return true;
    }

    public YamlMappingNode Write() =>
        Guid == null
            ? Nodes.Braces(("fileID", Nodes.Number(FileId)))
            : Nodes.Braces(("fileID", Nodes.Number(FileId)), ("guid", Nodes.Text(Guid)), ("type", Nodes.Number(Type)));

    public override string ToString() =>
        Guid == null
            ? "{fileID: " + Numbers.Write(FileId) + "}"
            : "{fileID: " + Numbers.Write(FileId) + ", guid: " + Guid + ", type: " + Numbers.Write(Type) + "}";

    static bool TryReadNumber(YamlMappingNode mapping, string name, out long value)
    {
        value = 0;
        return Nodes.Find(mapping, name) is YamlScalarNode scalar && Numbers.TryRead(scalar.Value, out value);
    }
}
