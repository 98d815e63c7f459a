namespace Nowpose.Metas;

/// <summary>A file or folder that Unity imports and that therefore needs a .meta beside it.</summary>
/// <param name="Path">Relative to the repository root, with forward slashes on every system.</param>
/// <param name="IsFolder">Folders carry <c>folderAsset: yes</c>.</param>
public sealed record AssetEntry(string Path, bool IsFolder)
{
    public string MetaPath => Path + AssetNames.MetaSuffix;
}
