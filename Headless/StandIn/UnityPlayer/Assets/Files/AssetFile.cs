using System.IO;

namespace Nowpose.UnityPlayer.Assets.Files;

/// <summary>An asset as its .meta introduces it. The asset itself need not be there: of a script nobody reads the source.</summary>
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

    /// <summary>As Unity calls it, with forward slashes: <c>Assets/…</c>, <c>Packages/…</c>.</summary>
    public string Path { get; }

    public string FullPath { get; }

    /// <summary>Name of the importer's block in the .meta.</summary>
    public string Importer { get; }

    /// <summary>Without its ending, which is what Unity calls the main object of most assets.</summary>
    public string Name => System.IO.Path.GetFileNameWithoutExtension(Path);

    /// <summary>With its dot, in lower case.</summary>
    public string Extension => System.IO.Path.GetExtension(Path).ToLowerInvariant();

    /// <exception cref="AssetException">The file is missing.</exception>
    public string ReadText()
    {
        return File.Exists(FullPath) ? File.ReadAllText(FullPath) : throw new AssetException(Path + ": there is a .meta but no such file");
    }
}
