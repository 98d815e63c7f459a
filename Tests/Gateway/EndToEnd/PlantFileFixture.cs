using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>A folder with plant files.</summary>
public abstract class PlantFileFixture
{
    private protected const string Good = """
        plant:
          kind: opcua
          name: absent
          endpoint: opc.tcp://127.0.0.1:9
        joints:
          - joint: a
            node: "ns=1;s=a"
        """;

    private protected TemporaryFolder _folder;

    [SetUp]
    public void MakeFolder()
    {
        Needs.Adapters();
        _folder = new TemporaryFolder();
    }

    [TearDown]
    public void RemoveFolder() => _folder?.Dispose();

    private protected string Write(string text, string name = "plant.yaml")
    {
        var path = Path.Combine(_folder.Path, name);
        File.WriteAllText(path, text);
        return path;
    }
}
