namespace Nowpose.UnityPlayer.Assets.Files;

/// <summary>An asset with a .meta file. The file of the asset itself may be missing if it is never read; for example, that of a script.</summary>
/// <param name="Guid">GUID of the asset, as 32 hexadecimal digits.</param>
/// <param name="Path">
/// Path within the project with forward slashes, for example <c>Assets/Scenes/Demo.unity</c>. It starts with <c>Assets/</c> or <c>Packages/</c>.
/// </param>
/// <param name="FullPath">Path of the file on this machine.</param>
/// <param name="Importer">Name of the importer, as in the .meta file.</param>
sealed record AssetFile(string Guid, string Path, string FullPath, string Importer)
{
    /// <summary>File name without extension. In most assets, this is also the name of the main object.</summary>
    public string Name => System.IO.Path.GetFileNameWithoutExtension(Path);

    /// <summary>Extension of the file in lower case, with the dot.</summary>
    public string Extension => System.IO.Path.GetExtension(Path).ToLowerInvariant();

    /// <summary>Reads the file of the asset.</summary>
    /// <exception cref="AssetException">The file is missing.</exception>
    public string ReadText() =>
        File.Exists(FullPath) ? File.ReadAllText(FullPath)
            : throw new AssetException(AssetFault.MissingAsset, Path + ": there is a .meta but no such file");
}
