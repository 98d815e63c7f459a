namespace Nowpose.Metas;

/// <summary>Writes missing .meta files. Never changes existing ones.</summary>
public static class MetaWriter
{
    /// <returns>Paths of the written files, relative to the root.</returns>
    public static IReadOnlyList<string> WriteMissing(string root)
    {
        var tree = new AssetTree(root);
        var guids = new GuidSource(tree.Metas.Select(m => Read(tree, m).AssetGuid).Where(g => g != null));
        var missing = tree.Assets.Where(a => !File.Exists(tree.FullPath(a.MetaPath))).ToList();

        foreach (var asset in missing)
            File.WriteAllText(tree.FullPath(asset.MetaPath), MetaFile.Format(asset, guids.Next(asset.Path)));

        return missing.Select(a => a.MetaPath).ToList();
    }

    /// <summary>Removes .meta files without an asset.</summary>
    /// <returns>Paths of the removed files, relative to the root.</returns>
    public static IReadOnlyList<string> Prune(string root)
    {
        var tree = new AssetTree(root);
        var orphans = MetaCheck.Orphans(tree).ToList();
        foreach (var orphan in orphans) File.Delete(tree.FullPath(orphan));
        return orphans;
    }

    static MetaFile Read(AssetTree tree, string path) => new(File.ReadAllText(tree.FullPath(path)));
}
