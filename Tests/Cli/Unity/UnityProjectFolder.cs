using System.Text;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>A temporary Unity project with a version and a manifest. Deleted after the test.</summary>
sealed class UnityProjectFolder : IDisposable
{
    readonly TemporaryFolder _folder = new();

    public UnityProjectFolder(string manifest, string version = "2022.3.62f1")
    {
        Write("ProjectSettings/ProjectVersion.txt", $"m_EditorVersion: {version}\nm_EditorVersionWithRevision: {version} (0123456789ab)\n");
        if (manifest != null) Write("Packages/manifest.json", manifest);
    }

    public string Root => _folder.Path;

    public string Manifest => Read("Packages/manifest.json");

    public IEnumerable<string> Backups =>
        Directory.EnumerateFiles(At("Packages"), "manifest.json.backup*").Select(Path.GetFileName).Order(StringComparer.Ordinal);

    public string At(string path) => Path.Combine(Root, path);

    public string Read(string path) => Encoding.UTF8.GetString(File.ReadAllBytes(At(path)));

    public void Write(string path, string text) => Write(path, Encoding.UTF8.GetBytes(text));

    public void Write(string path, byte[] content)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(At(path)));
        File.WriteAllBytes(At(path), content);
    }

    /// <summary>Runs the command <c>unity</c> on this project.</summary>
    public Task<CliRun> RunAsync(params string[] options) => CliRun.OfAsync(["unity", Root, .. options]);

    public void Dispose() => _folder.Dispose();
}
