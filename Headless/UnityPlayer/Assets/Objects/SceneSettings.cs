using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>What a scene sets as a whole: nothing that the stand-in shows, so it is kept as it is.</summary>
static class SceneSettings
{
    static readonly Dictionary<int, string> Classes = new Dictionary<int, string>
    {
        [29] = "OcclusionCullingSettings",
        [104] = "RenderSettings",
        [157] = "LightmapSettings",
        [196] = "NavMeshSettings",
    };

    public static bool Holds(UnityDocument document) => Classes.TryGetValue(document.ClassId, out var name) && name == document.ClassName;

    /// <exception cref="AssetException">A scene has each of them once, before its objects.</exception>
    public static IReadOnlyList<UnityDocument> Of(IReadOnlyList<UnityDocument> documents, string file)
    {
        var settings = documents.TakeWhile(Holds).ToList();
        return settings.Select(d => d.ClassId).SequenceEqual(Classes.Keys) && documents.Count(Holds) == Classes.Count
            ? settings
            : throw new AssetException(file + ": a scene begins with " + string.Join(", ", Classes.Values));
    }
}
