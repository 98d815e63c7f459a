using System.CommandLine;
using System.Globalization;
using Nowpose.Gateway.Pairing;

namespace Nowpose.Gateway.Verbs;

/// <summary>pairings: lists the paired headsets and revokes their tokens.</summary>
static class PairingsVerb
{
    public static Command Create()
    {
        var file = new Option<string>("--pairing") { Description = "The gateway's list of headsets", HelpName = "FILE", Required = true };
        var revoke = new Option<string>("--revoke")
        {
            Description = "Remove all headsets of this name; a gateway that runs ends their connections at once", HelpName = "NAME",
        };
        var command = new Command("pairings", "Lists the paired headsets, oldest first; also while the gateway runs") { file, revoke };
        command.SetAction(parsed =>
        {
            var path = parsed.GetValue(file);
            if (!File.Exists(path))
                throw new InputException($"--pairing {path}: there is no such file; a gateway with --pairing makes it");
            var name = parsed.GetValue(revoke);
            if (name != null) Revoke(path, name);
            foreach (var headset in HeadsetFile.Load(path))
                Console.Out.WriteLine(
                    $"headset {headset.PairedUtc.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture)} {headset.Name}");
        });
        return command;
    }

    static void Revoke(string path, string name)
    {
        var headsets = HeadsetFile.Load(path);
        var gone = headsets.Where(headset => headset.Name == name).ToArray();
        if (gone.Length == 0)
        {
            var there = headsets.Count == 0 ? "none" : string.Join(", ", headsets.Select(headset => $"'{headset.Name}'"));
            throw new InputException($"--revoke '{name}': no headset is of this name; there are {there}");
        }

        HeadsetFile.Remove(path, gone);
    }
}
