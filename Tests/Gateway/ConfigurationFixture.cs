using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>A folder with a configuration file, and the gateway that reads it.</summary>
public abstract class ConfigurationFixture
{
    private protected string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-configuration-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    private protected string Save(string text, string name = "gateway.yaml")
    {
        var path = Path.Combine(_folder, name);
        File.WriteAllText(path, text);
        return path;
    }

    private protected Task<(int Status, string[] Output, string[] Errors)> CheckAsync(string text, params string[] typed) => RunAsync(text, true, typed);

    private protected async Task<(int Status, string[] Output, string[] Errors)> RunAsync(string text, bool isCheck, params string[] typed)
    {
        string[] check = isCheck ? ["--check"] : [];
        var (status, output, errors) = await CapturedConsole.OfAsync(
            () => Nowpose.Gateway.CommandLine.RunAsync(["serve", "--config", Save(text), .. check, .. typed]).Bounded());
        return (status, CapturedConsole.Lines(output), CapturedConsole.Lines(errors));
    }
}
