using System.IO;

namespace Nowpose.UnityPlayer.Assets.Files;

/// <summary>An asset with a .meta file. The asset's own file may be missing: the source of a script, for example, is not read.</summary>
sealed class AssetFile
{
    public AssetFile(string guid, string path, string fullPath, string importer)
    {
        Guid = guid;
        Path = path;
        FullPath = fullPath;
        Importer = importer;
    }

    public string Guid { get; }

    /// <summary>Path in Unity's form, with forward slashes: <c>Assets/…</c>, <c>Packages/…</c>.</summary>
    public string Path { get; }

    public string FullPath { get; }

    /// <summary>Name of the importer's block in the .meta.</summary>
    public string Importer { get; }

    /// <summary>File name without its extension, which is Unity's name of the main object of most assets.</summary>
    public string Name => System.IO.Path.GetFileNameWithoutExtension(Path);

    /// <summary>Extension with its dot, in lower case.</summary>
    public string Extension => System.IO.Path.GetExtension(Path).ToLowerInvariant();

    /// <exception cref="AssetException">The file is missing.</exception>
    public string ReadText()
    {
        return File.Exists(FullPath) ? File.ReadAllText(FullPath) : throw new AssetException(Path + ": there is a .meta but no such file");
    }
}
