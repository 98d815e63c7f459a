using System.Globalization;
using System.Security.Cryptography;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Nowpose.Packing;

/// <summary>Writes an OCI image layout to a folder. It contains images for several processor architectures under one name.</summary>
public sealed class ImageLayout
{
    const string Media = "application/vnd.oci.image.";

    readonly string _folder;
    readonly DateTimeOffset _time;
    readonly JsonArray _manifests = [];

    /// <param name="time">Time stamp of all files and of the images.</param>
    public ImageLayout(string folder, DateTimeOffset time)
    {
        _folder = folder;
        _time = time;
        Directory.CreateDirectory(Path.Combine(folder, "blobs", "sha256"));
        File.WriteAllText(Path.Combine(folder, "oci-layout"), """{"imageLayoutVersion":"1.0.0"}""");
    }

    /// <summary>Adds the image for one processor architecture.</summary>
    /// <param name="architecture">Name of the architecture, for example amd64.</param>
    /// <param name="settings">Settings with which a container runs the program.</param>
    /// <param name="layers">Layers with their descriptions, lowest first.</param>
    public void Add(string architecture, ImageSettings settings, params (string Description, IEnumerable<ArchiveEntry> Entries)[] layers)
    {
        var written = layers.Select(layer => Layer(layer.Entries)).ToArray();
        var created = _time.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture);
        var config = Blob("config.v1+json", new JsonObject
        {
            ["created"] = created,
            ["architecture"] = architecture,
            ["os"] = "linux",
            ["config"] = settings.Json.DeepClone(),
            ["rootfs"] = new JsonObject
            {
                ["type"] = "layers", ["diff_ids"] = new JsonArray([.. written.Select(layer => (JsonNode)layer.Uncompressed)]),
            },
            ["history"] = new JsonArray([.. layers.Select(layer => new JsonObject { ["created"] = created, ["created_by"] = layer.Description })]),
        });
        var manifest = Blob("manifest.v1+json", new JsonObject
        {
            ["schemaVersion"] = 2,
            ["mediaType"] = Media + "manifest.v1+json",
            ["config"] = config,
            ["layers"] = new JsonArray([.. written.Select(layer => layer.Descriptor)]),
        });
        manifest["platform"] = new JsonObject { ["architecture"] = architecture, ["os"] = "linux" };
        _manifests.Add(manifest);
    }

    /// <summary>Writes the index. Must be called after the last image was added.</summary>
    /// <param name="name">Name of the images, for example nowpose-gateway:0.2.0.</param>
    /// <param name="annotations">Annotations of the images, with their standard keys.</param>
    public void Complete(string name, IReadOnlyDictionary<string, string> annotations)
    {
        var images = Blob("index.v1+json", Index(_manifests, annotations));
        images["annotations"] = new JsonObject
        {
            // containerd's tools read the full name; tools that support only the standard key read the tag.
            ["io.containerd.image.name"] = name,
            ["org.opencontainers.image.ref.name"] = name[(name.LastIndexOf(':') + 1)..],
        };
        File.WriteAllText(Path.Combine(_folder, "index.json"), Index([images], null).ToJsonString());
    }

    static JsonObject Index(JsonArray manifests, IReadOnlyDictionary<string, string> annotations)
    {
        var index = new JsonObject { ["schemaVersion"] = 2, ["mediaType"] = Media + "index.v1+json", ["manifests"] = manifests };
        if (annotations != null) index["annotations"] = JsonSerializer.SerializeToNode(annotations);
        return index;
    }

    (JsonObject Descriptor, string Uncompressed) Layer(IEnumerable<ArchiveEntry> entries)
    {
        var path = Path.Combine(_folder, "layer.tmp");
        using (var file = File.Create(path)) Archive.WriteTarGz(file, entries, _time);
        string uncompressed;
        using (var content = new System.IO.Compression.GZipStream(File.OpenRead(path), System.IO.Compression.CompressionMode.Decompress))
            uncompressed = Digest(content);
        return (Store("layer.v1.tar+gzip", path), uncompressed);
    }

    JsonObject Blob(string type, JsonObject content)
    {
        var path = Path.Combine(_folder, "blob.tmp");
        File.WriteAllText(path, content.ToJsonString());
        return Store(type, path);
    }

    JsonObject Store(string type, string path)
    {
        string digest;
        using (var content = File.OpenRead(path)) digest = Digest(content);
        var size = new FileInfo(path).Length;
        File.Move(path, Path.Combine(_folder, "blobs", "sha256", digest["sha256:".Length..]), overwrite: true);
        return new JsonObject { ["mediaType"] = Media + type, ["digest"] = digest, ["size"] = size };
    }

    static string Digest(Stream content) => "sha256:" + Convert.ToHexStringLower(SHA256.HashData(content));
}
