using System.Text.Json.Nodes;

namespace Nowpose.Packing;

/// <summary>Settings with which a container runs its program, from the last stage of a Containerfile.</summary>
/// <param name="Json">Settings in the format of OCI images. This format does not support health checks.</param>
/// <param name="UserId">Id of the user and the group.</param>
/// <param name="State">Folder that the user owns.</param>
public sealed record ImageSettings(JsonObject Json, int UserId, string State)
{
    /// <param name="userId">Id of the user. The Containerfile contains only the user's name, which the base image defines.</param>
    public static ImageSettings Read(string containerfile, int userId)
    {
        var lines = containerfile.Replace("\\\n", " ", StringComparison.Ordinal).Split('\n')
            .Select(line => line.Split(' ', 2)).Where(words => words.Length == 2).ToArray();
        var stage = lines[Array.FindLastIndex(lines, words => words[0] == "FROM")..];
        string[] All(string instruction) => [.. stage.Where(words => words[0] == instruction).Select(words => words[1].Trim())];
        JsonArray List(string instruction) => JsonNode.Parse(All(instruction).Single()).AsArray();

        var folder = All("WORKDIR").Single();
        var json = new JsonObject
        {
            ["User"] = $"{userId}:{userId}",
            ["ExposedPorts"] = Set(All("EXPOSE").SelectMany(ports => ports.Split(' '))),
            ["Env"] = new JsonArray([.. All("ENV").Select(value => (JsonNode)value)]),
            ["Entrypoint"] = List("ENTRYPOINT"),
            ["Cmd"] = List("CMD"),
            ["Volumes"] = Set(List("VOLUME").Select(volume => volume.GetValue<string>())),
            ["WorkingDir"] = folder,
            ["StopSignal"] = All("STOPSIGNAL").Single(),
        };
        return new ImageSettings(json, userId, folder.TrimStart('/'));
    }

    static JsonObject Set(IEnumerable<string> names) => new(names.Select(name => KeyValuePair.Create(name, (JsonNode)new JsonObject())));
}
