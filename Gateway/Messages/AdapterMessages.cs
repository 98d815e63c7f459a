using System.Net;

namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about adapters and their configurations, with remedies.</summary>
static class AdapterMessages
{
    public static string Ended(string file, string end, double seconds) =>
        FormattableString.Invariant($"{file}: its adapter ended ({end}) and starts again in {seconds:0.#} s");

    public static string NoTls(IPAddress address) =>
        $"--plant with --bind {address} and no --tls: adapters connect only over TLS or loopback; add --tls, or use --bind any";

    public static string SameName(string file, string plant, string other) =>
        $"{file}: its plant has the same name '{plant}' as the one in {other}; set another plant.name in one of the two files";

    public static string SamePassword(string file, string variable, string other) =>
        $"{file}: {variable} has the password of its plant and of the one in {other}, because their names differ only in - and _; set another"
            + " plant.name or user.password_file in one of the two files, or user.shared_password: true in both";

    public static string SecondConnection(string file, string machine, string other) =>
        $"{file}: {other} also connects to {machine}, which accepts only one connection from this machine because it has no TwinCAT router;"
            + " combine the two files, or install a TwinCAT router on this machine, remove local_net_id from both files and use ads://127.0.0.1/…";

    public static string CheckTooSlow(string file, double seconds) =>
        $"{file}: the adapter did not finish the check of this file within {seconds} s; try again when the machine is less busy";

    public static string FormerKey(string adapter, string former, string current) =>
        $"adapter {adapter}: uses the former key {former}NAME in its reports, which the next release will ignore; update it to use {current}NAME";

    public static string TooMany(string adapter, int most) =>
        $"adapter {adapter}: its reports about objects and signals are ignored, because {most} other adapters report some; use a second gateway for it";

    public const string NodeNeeded = "--plant: Node.js 20 or newer is needed to read a control system";

    public static string CheckUnreadable(string file) =>
        $"{file}: the adapter's result for this file cannot be read; build the gateway and the adapters from the same version";
}
