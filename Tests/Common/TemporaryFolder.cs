namespace Nowpose.Tests.Common;

/// <summary>A temporary folder of a test, deleted when disposed.</summary>
sealed class TemporaryFolder : IDisposable
{
    public string Path { get; } = Directory.CreateTempSubdirectory("nowpose-").FullName;

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
