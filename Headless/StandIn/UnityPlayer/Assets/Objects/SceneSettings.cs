using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>The settings of a scene as a whole. The stand-in does not use them and keeps them unchanged.</summary>
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

    /// <summary>Ambient light of one colour, no sky, no fog, nothing baked.</summary>
    public static IReadOnlyList<UnityDocument> Default => UnityDocumentReader.Read(NewScene, "a new scene");

    public static bool Holds(UnityDocument document) => Classes.TryGetValue(document.ClassId, out var name) && name == document.ClassName;

    /// <exception cref="AssetException">A scene must have each of them exactly once, before its objects.</exception>
    public static IReadOnlyList<UnityDocument> Of(IReadOnlyList<UnityDocument> documents, string file)
    {
        var settings = documents.TakeWhile(Holds).ToList();
        return settings.Select(d => d.ClassId).SequenceEqual(Classes.Keys) && documents.Count(Holds) == Classes.Count
            ? settings
            : throw new AssetException(file + ": a scene begins with " + string.Join(", ", Classes.Values));
    }
}
