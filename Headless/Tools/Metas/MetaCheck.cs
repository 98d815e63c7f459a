namespace Nowpose.Metas;

/// <summary>Finds faults that would make Unity's import fail or give different results on two machines.</summary>
public static class MetaCheck
{
    /// <returns>One line per fault, starting with the path; empty if there are none.</returns>
    public static IReadOnlyList<string> Faults(string root)
    {
        var tree = new AssetTree(root);
        var metas = tree.Metas.ToDictionary(m => m, m => new MetaFile(File.ReadAllText(tree.FullPath(m))));

        return tree.Assets.SelectMany(a => FaultsOf(a, metas.GetValueOrDefault(a.MetaPath)))
            .Concat(Orphans(tree).Select(m => $"{m}: its asset does not exist; remove it with --prune"))
            .Concat(Duplicates(metas))
            .Concat(tree.BuildFiles.Select(b => $"{b}: a .NET build file here would be imported by Unity; keep it outside"))
            .ToList();
    }

    internal static IEnumerable<string> Orphans(AssetTree tree)
    {
        var expected = tree.Assets.Select(a => a.MetaPath).ToHashSet();
        return tree.Metas.Where(m => !expected.Contains(m));
    }

    static IEnumerable<string> FaultsOf(AssetEntry asset, MetaFile meta)
    {
        if (meta == null)
        {
            yield return $"{asset.Path}: has no .meta";
            yield break;
        }
        var importer = Importer.For(asset).Name;
        if (meta.AssetGuid == null) yield return $"{asset.MetaPath}: has no guid of 32 lower-case hex digits";
        if (meta.ImporterName != importer)
            yield return $"{asset.MetaPath}: importer is {meta.ImporterName ?? "missing"}, {importer} is needed";
        if (asset.IsFolder && !meta.IsFolder) yield return $"{asset.MetaPath}: folder without folderAsset: yes";
        if (!asset.IsFolder && meta.IsFolder) yield return $"{asset.MetaPath}: folderAsset: yes on a file";
    }

    static IEnumerable<string> Duplicates(Dictionary<string, MetaFile> metas)
    {
        return metas.Where(m => m.Value.AssetGuid != null)
            .OrderBy(m => m.Key, StringComparer.Ordinal)
            .GroupBy(m => m.Value.AssetGuid, m => m.Key)
            .SelectMany(same => same.Skip(1).Select(m => $"{m}: guid {same.Key} is also that of {same.First()}"));
    }
}
