using System.Formats.Tar;
using System.IO.Compression;
using System.Security.Cryptography;
using System.Text.Json;
using Nowpose.Packing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Packing;

public sealed class ImageLayoutTests
{
    static readonly string Containerfile = RepositoryFiles.Read("Gateway/Packaging/Containerfile");

    string _root;

    [SetUp]
    public void SetUp()
    {
        _root = Directory.CreateTempSubdirectory("nowpose-layout-").FullName;
        foreach (var file in new[] { "libraries/lib/libc.so", "program/nowpose-gateway" })
        {
            Directory.CreateDirectory(Path.GetDirectoryName(At(file)));
            File.WriteAllText(At(file), file);
        }
        var layout = new ImageLayout(At("layout"), DateTimeOffset.UnixEpoch);
        foreach (var architecture in new[] { "amd64", "arm64" }) GatewayImage.Add(layout, architecture, Containerfile, At("libraries"), At("program"));
        layout.Complete("nowpose-gateway:1.2.3", new Dictionary<string, string> { ["org.opencontainers.image.version"] = "1.2.3" });
    }

    [TearDown]
    public void TearDown() => Directory.Delete(_root, true);

    string At(string path) => Path.Combine(_root, path);

    byte[] Blob(JsonElement descriptor) => File.ReadAllBytes(At("layout/blobs/" + descriptor.GetProperty("digest").GetString().Replace(':', '/')));

    JsonElement Json(JsonElement descriptor) => JsonDocument.Parse(Blob(descriptor)).RootElement;

    JsonElement Index => JsonDocument.Parse(File.ReadAllText(At("layout/index.json"))).RootElement;

    JsonElement[] Images => [.. Json(Index.GetProperty("manifests")[0]).GetProperty("manifests").EnumerateArray()];

    static string Digest(Stream content) => "sha256:" + Convert.ToHexStringLower(SHA256.HashData(content));

    [Test]
    public void Blobs_AllFiles_AreNamedByTheirDigest()
    {
        var blobs = Directory.GetFiles(At("layout/blobs/sha256"));

        Assert.That(blobs.Select(path => "sha256:" + Path.GetFileName(path)), Is.EqualTo(blobs.Select(path => Digest(new MemoryStream(File.ReadAllBytes(path))))));
        Assert.That(Directory.GetFiles(At("layout")).Select(Path.GetFileName), Is.EquivalentTo(new[] { "index.json", "oci-layout" }));
    }

    [Test]
    public void Index_SeveralArchitectures_NamesTheTagAndEachPlatform()
    {
        var image = Index.GetProperty("manifests")[0];

        Assert.That(image.GetProperty("annotations").GetProperty("org.opencontainers.image.ref.name").GetString(), Is.EqualTo("1.2.3"));
        Assert.That(image.GetProperty("size").GetInt64(), Is.EqualTo(Blob(image).Length));
        Assert.That(Images.Select(each => each.GetProperty("platform").GetProperty("architecture").GetString()), Is.EqualTo(new[] { "amd64", "arm64" }));
    }

    [Test]
    public void Config_Layers_HasTheDigestsOfTheUncompressedLayers()
    {
        var manifest = Json(Images[0]);
        var layers = manifest.GetProperty("layers").EnumerateArray().Select(Blob)
            .Select(layer => Digest(new GZipStream(new MemoryStream(layer), CompressionMode.Decompress)));

        var listed = Json(manifest.GetProperty("config")).GetProperty("rootfs").GetProperty("diff_ids").EnumerateArray().Select(id => id.GetString());

        Assert.That(listed, Is.EqualTo(layers));
    }

    [Test]
    public void Config_Containerfile_HasTheSameEntryPoint()
    {
        var config = Json(Json(Images[0]).GetProperty("config")).GetProperty("config");

        Assert.That(config.GetProperty("Entrypoint")[0].GetString(), Is.EqualTo("/opt/nowpose-gateway/Nowpose.Gateway"));
        Assert.That(config.GetProperty("Cmd")[0].GetString(), Is.EqualTo("serve"));
        Assert.That(config.GetProperty("User").GetString(), Is.EqualTo("1654:1654"));
        Assert.That(config.GetProperty("StopSignal").GetString(), Is.EqualTo("SIGTERM"));
        Assert.That(config.GetProperty("ExposedPorts").EnumerateObject().Select(port => port.Name), Is.EqualTo(new[] { "47010/tcp", "47011/tcp" }));
        Assert.That(config.GetProperty("Env").EnumerateArray().Select(value => value.GetString()), Does.Contain("MALLOC_ARENA_MAX=1"));
    }

    [Test]
    public void SystemLayer_StateFolder_IsOwnedByTheUser()
    {
        var entries = new Dictionary<string, (int Owner, int Mode)>();
        using var reader = new TarReader(new GZipStream(new MemoryStream(Blob(Json(Images[0]).GetProperty("layers")[1])), CompressionMode.Decompress));
        while (reader.GetNextEntry() is { } entry) entries.Add(entry.Name, (entry.Uid, (int)entry.Mode));

        Assert.That(entries["var/lib/nowpose-gateway/"].Owner, Is.EqualTo(1654));
        Assert.That(Convert.ToString(entries["tmp/"].Mode, 8), Is.EqualTo("1777"));
        Assert.That(entries["opt/nowpose-gateway/nowpose-gateway"].Owner, Is.Zero);
    }
}
