namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>An instance of a prefab in another file. The fileIDs of its objects are computed as in Unity.</summary>
sealed class PrefabInstance(string file, long fileId, string sourceGuid, ObjectFile source)
{
    /// <summary>Class number of the document that contains the parent and the changes of an instance.</summary>
    public const int ClassId = 1001;

    /// <summary>FileID in references to a prefab as a whole.</summary>
    public const long PrefabFileId = 100100000;

    /// <summary>Name of the file that contains the instance; null for an instance that was not read from a file.</summary>
    public string File { get; } = file;

    public long FileId { get; } = fileId;
    public string SourceGuid { get; } = sourceGuid;
    public ObjectFile Source { get; } = source;

    /// <summary>Returns the fileID that an object of the prefab has in this file. Returns 0 (no object) for 0.</summary>
    public long Map(long sourceFileId) => sourceFileId == 0 ? 0 : (FileId ^ sourceFileId) & long.MaxValue;
}

/// <summary>One value, a scalar or a reference, in which an object of a prefab instance differs from the prefab.</summary>
readonly record struct Modification(string Path, string Value, AssetReference Reference)
{
    public YamlMappingNode Write(AssetReference target) => Nodes.Lines(
        ("target", target.Write()),
        ("propertyPath", Nodes.Text(Path)),
        ("value", Nodes.Text(Value)),
        ("objectReference", Reference.Write()));
}

/// <summary>Identifies the prefab object that an object instantiates.</summary>
sealed record PrefabLink(PrefabInstance Instance, long SourceFileId);
