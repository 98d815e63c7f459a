namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Settings of a whole scene. The stand-in does not use them, but stores them unchanged.</summary>
static class SceneSettings
{
    static readonly Dictionary<int, string> Classes = new Dictionary<int, string>
    {
        [29] = "OcclusionCullingSettings",
        [104] = "RenderSettings",
        [157] = "LightmapSettings",
        [196] = "NavMeshSettings",
    };

    const string NewScene = @"%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!29 &1
OcclusionCullingSettings:
  m_ObjectHideFlags: 0
  serializedVersion: 2
  m_OcclusionBakeSettings:
    smallestOccluder: 5
    smallestHole: 0.25
    backfaceThreshold: 100
  m_SceneGUID: 00000000000000000000000000000000
  m_OcclusionCullingData: {fileID: 0}
--- !u!104 &2
RenderSettings:
  m_ObjectHideFlags: 0
  serializedVersion: 9
  m_Fog: 0
  m_AmbientSkyColor: {r: 0.45, g: 0.47, b: 0.5, a: 1}
  m_AmbientIntensity: 1
  m_AmbientMode: 3
  m_SkyboxMaterial: {fileID: 0}
--- !u!157 &3
LightmapSettings:
  m_ObjectHideFlags: 0
  serializedVersion: 12
  m_GIWorkflowMode: 1
  m_LightmapEditorSettings:
    serializedVersion: 12
    m_MixedBakeMode: 2
  m_LightingDataAsset: {fileID: 0}
  m_LightingSettings: {fileID: 0}
--- !u!196 &4
NavMeshSettings:
  serializedVersion: 2
  m_ObjectHideFlags: 0
  m_NavMeshData: {fileID: 0}
";

    /// <summary>Settings of a new scene: ambient light of one colour, no sky, no fog, no baked data.</summary>
    public static IReadOnlyList<UnityDocument> Default => UnityDocumentReader.Read(NewScene, "a new scene");

    public static bool Holds(UnityDocument document) => Classes.TryGetValue(document.ClassId, out var name) && name == document.ClassName;

    /// <summary>Returns the settings among the documents of a scene file.</summary>
    /// <exception cref="AssetException">The settings are not complete, occur twice, or do not precede the objects.</exception>
    public static IReadOnlyList<UnityDocument> Of(IReadOnlyList<UnityDocument> documents, string file)
    {
        var settings = documents.TakeWhile(Holds).ToList();
        return settings.Select(d => d.ClassId).SequenceEqual(Classes.Keys) && documents.Count(Holds) == Classes.Count
            ? settings
            : throw new AssetException(AssetFault.Document, file + ": a scene begins with " + string.Join(", ", Classes.Values));
    }
}
