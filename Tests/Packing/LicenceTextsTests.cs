using Nowpose.Packing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Packing;

public sealed class LicenceTextsTests
{
    static readonly Dictionary<string, string> Standard = new() { ["MIT"] = "Permission is hereby granted", ["Apache-2.0"] = "Apache License" };

    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-licences-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    string TextOf(string licence)
    {
        File.WriteAllText(Path.Combine(_folder, "thing.nuspec"), $"""
            <package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd"><metadata>
              <id>Thing</id><version>1.0.0</version><license type="expression">{licence}</license><copyright>Copyright Acme</copyright>
            </metadata></package>
            """);
        var texts = new LicenceTexts(Standard);
        texts.Add(_folder);
        return texts.ToString();
    }

    [TestCase("MIT", "Permission is hereby granted")]
    [TestCase("MS-PL OR Apache-2.0", "Apache License")]
    public void Add_PackageWithoutLicenceText_UsesTheStandardText(string licence, string text) =>
        Assert.That(TextOf(licence), Does.StartWith($"Thing 1.0.0, {licence}\n\nCopyright Acme\n\n{text}\n"));

    [Test]
    public void Add_LicenceTextInThePackage_UsesIt()
    {
        File.WriteAllText(Path.Combine(_folder, "License.txt"), "its own words");

        Assert.That(TextOf("MIT"), Does.Contain("its own words").And.Not.Contain("Permission"));
    }

    [Test]
    public void Add_UnknownLicence_Throws() => Assert.That(() => TextOf("GPL-2.0"), Throws.InstanceOf<InvalidDataException>().With.Message.Contains("Thing 1.0.0"));
}
