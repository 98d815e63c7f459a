using System.Globalization;
using System.Text.Json.Nodes;
using Nowpose.Packing;

const string Help = """
    Packs a release. The environment variable SOURCE_DATE_EPOCH is the time of all files, in seconds.

      archive FOLDER FILE              packs a folder as .zip or .tar.gz
      image NAME COMMIT FILE.tar CONTAINERFILE (ARCHITECTURE LIBRARIES PROGRAM)...
                                       packs an OCI image layout
      bill FILE VERSION COMMIT NOTICES ADAPTER_LICENCES OTHERS BILL...
                                       joins bills of materials; OTHERS has lines with a package address, a tab and a licence
      licences FILE LICENCE APACHE PACKAGE...
                                       collects the licences of NuGet packages, given as folders

    Exit status: 0 done, 1 failed, 2 wrong use.
    """;

var time = DateTimeOffset.FromUnixTimeSeconds(
    long.Parse(Environment.GetEnvironmentVariable("SOURCE_DATE_EPOCH") ?? "0", NumberStyles.None, CultureInfo.InvariantCulture));
try
{
    switch (args)
    {
        case ["archive", var folder, var file]:
            Archive.Write(file, ArchiveEntry.OfFolder(folder, Path.GetFileName(Path.GetFullPath(folder))), time);
            return 0;
        case ["image", var name, var commit, var file, var containerfile, .. var images] when images.Length > 0 && images.Length % 3 == 0:
            WriteImage(name, commit, file, File.ReadAllText(containerfile), images);
            return 0;
        case ["bill", var file, var version, var commit, var notices, var adapterLicences, var others, .. var bills]:
            File.WriteAllText(file, Joined(File.ReadAllText(notices), File.ReadAllText(adapterLicences), others, bills).Complete(version, commit, time));
            return 0;
        case ["licences", var file, var licence, var apache, .. var packages]:
            WriteLicences(file, File.ReadAllText(licence), File.ReadAllText(apache), packages);
            return 0;
        default:
            Console.Error.WriteLine(Help);
            return 2;
    }
}
catch (Exception failure) when (failure is IOException or InvalidDataException or UnauthorizedAccessException)
{
    Console.Error.WriteLine("packing: " + failure.Message);
    return 1;
}

void WriteImage(string name, string commit, string file, string containerfile, string[] images)
{
    var folder = Directory.CreateTempSubdirectory("nowpose-image-").FullName;
    try
    {
        var layout = new ImageLayout(folder, time);
        foreach (var image in images.Chunk(3)) GatewayImage.Add(layout, image[0], containerfile, image[1], image[2]);
        layout.Complete(name, new Dictionary<string, string>
        {
            ["org.opencontainers.image.title"] = "Nowpose gateway",
            ["org.opencontainers.image.version"] = name[(name.LastIndexOf(':') + 1)..],
            ["org.opencontainers.image.revision"] = commit,
            ["org.opencontainers.image.licenses"] = "MIT",
        });
        Archive.Write(file, ArchiveEntry.OfFolder(folder, ""), time);
    }
    finally
    {
        Directory.Delete(folder, true);
    }
}

static BillOfMaterials Joined(string notices, string adapterLicences, string others, string[] bills)
{
    var shipped = Notices.ShippedIn(notices).Concat(Notices.BundledIn(adapterLicences)).ToHashSet(StringComparer.Ordinal);
    var joined = new BillOfMaterials();
    foreach (var bill in bills.Select(path => JsonNode.Parse(File.ReadAllText(path)).AsObject()))
        // npm's SBOM also lists packages that only the build uses. NuGet's SBOM marks such packages.
        joined.Add(bill, IsOfNpm(bill) ? shipped.Contains : _ => true);
    foreach (var line in File.ReadLines(others).Select(line => line.Split('\t'))) joined.Add(line[0], line[1]);
    return joined;
}

static bool IsOfNpm(JsonObject bill) =>
    bill["components"]!.AsArray().Any(component => component["purl"]!.GetValue<string>().StartsWith("pkg:npm/", StringComparison.Ordinal));

static void WriteLicences(string file, string licence, string apache, string[] packages)
{
    // The MIT licence has the same text in all packages, except for the copyright line.
    var mit = licence[licence.IndexOf("Permission is hereby granted", StringComparison.Ordinal)..];
    var texts = new LicenceTexts(new Dictionary<string, string> { ["MIT"] = mit, ["Apache-2.0"] = apache });
    foreach (var package in packages) texts.Add(package);
    File.WriteAllText(file, texts.ToString());
}
