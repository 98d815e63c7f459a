namespace Nowpose.Tests.Common;

/// <summary>A folder of a test's own, gone with it.</summary>
sealed class TemporaryFolder : IDisposable
{
    public string Path { get; } = Directory.CreateTempSubdirectory("nowpose-").FullName;

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
