namespace Nowpose.Metas;

/// <summary>A file or folder that Unity imports, and which therefore needs a .meta file.</summary>
/// <param name="Path">Path relative to the repository root, with forward slashes on all systems.</param>
/// <param name="IsFolder">Whether the asset is a folder. The .meta file of a folder contains <c>folderAsset: yes</c>.</param>
public sealed record AssetEntry(string Path, bool IsFolder)
{
    public string MetaPath => Path + AssetNames.MetaSuffix;
}
