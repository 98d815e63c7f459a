using Nowpose.UnityPlayer;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>A Unity project with a few files in a temporary folder, which Dispose deletes.</summary>
sealed class TemporaryProject : IDisposable
{
    public const string YamlHeader = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

    readonly string _root = Directory.CreateTempSubdirectory("nowpose-assets-").FullName;

    /// <summary>Returns the GUID for an asset number: the number as 32 hexadecimal digits, so that it is easy to write in a test.</summary>
    public static string GuidOf(int number) => number.ToString("x32", System.Globalization.CultureInfo.InvariantCulture);

    public AssetLibrary Library() => new(_root);

    public string Read(string path) => File.ReadAllText(Path.Combine(_root, path));

    public TemporaryProject Add(string path, int guid, string text, string importer = "TextScriptImporter")
    {
        var full = Path.Combine(_root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(full));
        if (text != null) File.WriteAllText(full, text);
        File.WriteAllText(full + ".meta", $"fileFormatVersion: 2\nguid: {GuidOf(guid)}\n{importer}:\n  userData: \n");
        return this;
    }

    public TemporaryProject AddYaml(string path, int guid, string body) => Add(path, guid, YamlHeader + body, "PrefabImporter");

    /// <summary>Adds the .meta file of a script whose class is in the assembly of these tests.</summary>
    public TemporaryProject AddScript<T>(int guid)
    {
        Add("Assets/Scripts/Nowpose.Unity.Tests.asmdef", 0xa5, "{}", "AssemblyDefinitionImporter");
        return Add($"Assets/Scripts/{typeof(T).Name}.cs", guid, null, "MonoImporter");
    }

    public void Dispose() => Directory.Delete(_root, recursive: true);
}
