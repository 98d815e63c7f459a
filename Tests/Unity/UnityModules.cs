using System.Text.RegularExpressions;

namespace Nowpose.Unity.Tests;

/// <summary>
/// Finds Unity's module packages (<c>com.unity.modules.NAME</c>) that a source file or asset requires. Types of such a module are available only
/// if the project or a package depends on the module. Types in Unity's core modules are always available.
/// </summary>
static partial class UnityModules
{
    /// <summary>Names of the types and namespaces of each module, as regular expressions without word boundaries.</summary>
    static readonly (string Module, string Names)[] ByName =
    {
        ("ai", @"UnityEngine\.AI|NavMesh\w*"),
        ("androidjni", @"AndroidJava\w+|AndroidJNI\w*"),
        ("animation", @"UnityEngine\.Animations|Animat(ion|or|ionClip|ionEvent|orStateInfo|orOverrideController)|RuntimeAnimatorController"),
        ("assetbundle", @"AssetBundle\w*"),
        ("audio", @"UnityEngine\.Audio|Audio(Source|Clip|Listener|Mixer\w*|Settings|ReverbZone)|(?<!WSACapability\.)Microphone"),
        ("cloth", @"Cloth"),
        ("director", @"PlayableDirector"),
        ("imageconversion", @"ImageConversion|EncodeTo(PNG|JPG|TGA|EXR)|LoadImage"),
        ("imgui", @"GUI(Layout|LayoutOption|LayoutUtility|Style|StyleState|Content|Skin|Utility|Clip)?|OnGUI|Event\s*\.\s*current"),
        ("jsonserialize", @"JsonUtility"),
        ("particlesystem", @"ParticleSystem\w*"),
        ("physics", @"Rigidbody|Collider|(Box|Sphere|Capsule|Mesh)Collider|Physics|Physic(s)?Material|RaycastHit|Collision"
            + @"|ArticulationBody|CharacterController|(Hinge|Spring|Character|Configurable)Joint|UnityEngine\.FixedJoint"),
        ("physics2d", @"Rigidbody2D|\w*Collider2D|Physics2D|RaycastHit2D|Collision2D"),
        ("screencapture", @"ScreenCapture"),
        ("subsystems", @"UnityEngine\.SubsystemsImplementation|I(ntegrated)?Subsystem\w*|SubsystemManager"),
        ("terrain", @"Terrain(Data|Layer)?"),
        ("terrainphysics", @"TerrainCollider"),
        ("tilemap", @"UnityEngine\.Tilemaps"),
        ("ui", @"Canvas(Group|Renderer)?|RectTransformUtility"),
        ("uielements", @"Unity(Engine|Editor)\.UIElements"),
        ("unityanalytics", @"UnityEngine\.Analytics"),
        ("unitywebrequest", @"UnityEngine\.Networking|UnityWebRequest(AsyncOperation)?|(Down|Up)loadHandler(Buffer|Script|File|Raw)?|WWWForm"),
        ("unitywebrequestassetbundle", @"UnityWebRequestAssetBundle|DownloadHandlerAssetBundle"),
        ("unitywebrequestaudio", @"UnityWebRequestMultimedia|DownloadHandlerAudioClip"),
        ("unitywebrequesttexture", @"UnityWebRequestTexture|DownloadHandlerTexture"),
        ("vehicles", @"WheelCollider"),
        ("video", @"UnityEngine\.Video|VideoPlayer"),
        ("vr", @"XR(Settings|Device|Stats)"),
        ("wind", @"WindZone"),
        // Excludes UnityEngine.XR.SOMETHING, which is the namespace of an optional package. Such a package depends on the module itself.
        ("xr", @"UnityEngine\.XR(?!\s*\.\s*\w+(\s*;|\s*\.))|XR(Node|NodeState|DisplaySubsystem\w*|InputSubsystem\w*|MeshSubsystem\w*)|InputDevices"
            + @"|InputTracking"),
    };

    /// <summary>Numbers of the serialised classes of each module, which follow <c>!u!</c> in scenes and prefabs.</summary>
    static readonly (string Module, int[] Classes)[] ByClass =
    {
        ("ai", new[] { 195, 208 }),
        ("animation", new[] { 74, 91, 95, 111 }),
        ("audio", new[] { 81, 82, 83 }),
        ("cloth", new[] { 183 }),
        ("director", new[] { 320 }),
        ("particlesystem", new[] { 198, 199 }),
        ("physics", new[] { 54, 59, 64, 65, 134, 135, 136, 138, 143, 144, 145, 153, 171741748 }),
        ("physics2d", new[] { 50, 58, 60, 61, 66, 68, 70 }),
        ("terrain", new[] { 218 }),
        ("terrainphysics", new[] { 154 }),
        ("ui", new[] { 222, 223, 225 }),
        ("vehicles", new[] { 146 }),
        ("video", new[] { 328 }),
        ("wind", new[] { 182 }),
    };

    /// <summary>Returns the modules that a C# source file uses.</summary>
    /// <param name="source">The source. If it does not mention Unity, its own types may have the same names, and it uses no module.</param>
    public static IEnumerable<string> UsedByCode(string source)
    {
        var code = CSharpCode.Of(source);
        if (!Regex.IsMatch(code, @"\bUnity(Engine|Editor)\b")) return Enumerable.Empty<string>();
        return ByName.Where(m => Regex.IsMatch(code, $@"\b(?:{m.Names})\b")).Select(m => m.Module);
    }

    /// <summary>Returns the modules that an asset uses.</summary>
    /// <param name="yaml">Text of a scene, prefab or other asset.</param>
    public static IEnumerable<string> UsedByAsset(string yaml)
    {
        var classes = ClassNumbers().Matches(yaml).Select(m => int.Parse(m.Groups[1].Value)).ToHashSet();
        return ByClass.Where(m => m.Classes.Any(classes.Contains)).Select(m => m.Module);
    }

    /// <summary>Returns the modules that the sources, scenes and prefabs in a folder of the repository use, each module once.</summary>
    /// <param name="except">Subfolders that are excluded.</param>
    public static IEnumerable<string> UsedUnder(string folder, params string[] except)
    {
        bool IsLookedAt(string file) => !except.Any(e => file.StartsWith(e + "/", StringComparison.Ordinal));
        var code = RepositoryFiles.Under(folder, ".cs").Where(IsLookedAt).SelectMany(f => UsedByCode(RepositoryFiles.Read(f)));
        var assets = RepositoryFiles.Under(folder, ".unity", ".prefab", ".asset").Where(IsLookedAt)
            .SelectMany(f => UsedByAsset(RepositoryFiles.Read(f)));
        return code.Concat(assets).Distinct().Order(StringComparer.Ordinal);
    }

    [GeneratedRegex(@"^--- !u!(\d+) ", RegexOptions.Multiline)]
    private static partial Regex ClassNumbers();
}
