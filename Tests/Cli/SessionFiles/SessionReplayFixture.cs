using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>A folder for a recording of a session, and a run of the command line.</summary>
public abstract class SessionReplayFixture
{
    private protected string _folder, _path;

    [SetUp]
    public void CreateFolder()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-session-").FullName;
        _path = Path.Combine(_folder, "session.jsonl");
    }

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    private protected static Task<CliRun> Run(params string[] arguments) => CliRun.OfAsync(arguments);
}
