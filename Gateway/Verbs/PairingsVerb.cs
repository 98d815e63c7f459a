using System.CommandLine;
using System.Globalization;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Pairing;

namespace Nowpose.Gateway.Verbs;

/// <summary>The command "pairings", which lists the paired headsets and revokes their tokens.</summary>
static class PairingsVerb
{
    public static Command Create()
    {
        var file = new Option<string>("--pairing") { Description = "The gateway's list of headsets", HelpName = "FILE", Required = true };
        var revoke = TextOption.Create("--revoke", "Remove all headsets of this name; a running gateway ends their connections immediately", "NAME");
        var command = new Command("pairings", "List the paired headsets, oldest first; the gateway may be running") { file, revoke };
        command.SetAction(async (parsed, cancel) =>
        {
            var path = parsed.GetValue(file);
            if (!File.Exists(path))
                throw new InputException(VerbMessages.NoList(path));
            var name = parsed.GetValue(revoke);
            var headsets = await Invocation.ReadAsync(() => HeadsetFile.Load(path), cancel);
            if (name != null)
            {
                HeadsetFile.Remove(path, OfName(headsets, name));
                headsets = await Invocation.ReadAsync(() => HeadsetFile.Load(path), cancel);
            }

            foreach (var headset in headsets)
                Console.Out.WriteLine(
                    $"headset {headset.PairedUtc.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture)} {headset.Name}");
        });
        return command;
    }

    static PairedHeadset[] OfName(IReadOnlyList<PairedHeadset> headsets, string name)
    {
        var gone = headsets.Where(headset => headset.Name == name).ToArray();
        if (gone.Length > 0) return gone;
        var there = headsets.Count == 0 ? "none" : string.Join(", ", headsets.Select(headset => $"'{headset.Name}'"));
        throw new InputException(VerbMessages.UnknownHeadset(name, there));
    }
}
