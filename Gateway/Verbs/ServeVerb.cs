using System.CommandLine;
using Nowpose.Gateway.Robots;

namespace Nowpose.Gateway.Verbs;

/// <summary>serve: a gateway to which the sources connect.</summary>
static class ServeVerb
{
    public static Command Create()
    {
        var server = new ServerArguments();
        var robot = new Option<string>("--robot")
        {
            Description = "Robot description to hand to headsets: youbot, ur5 or the path of a .urdf file [default: a source sends it]",
            HelpName = "ROBOT",
        };
        var command = new Command("serve", "Serves what sources publish that connect to it");
        command.Options.Add(robot);
        server.AddTo(command);
        command.SetAction(async (parsed, stop) =>
        {
            var name = parsed.GetValue(robot);
            var description = name == null ? null : Describe(name);
            var clock = server.Clock(parsed);
            await using var gateway = await GatewayServer.StartAsync(server.Options(parsed), clock, Announcement.Log, stop);
            using var source = gateway.Hub.OpenSource();
            if (description != null)
                source.TryDescribe(description);
            Announcement.Write(gateway, clock, server.SkewPpm(parsed), name, null);
            await Task.Delay(Timeout.Infinite, stop);
        });
        return command;
    }

    // Read as well, so that a file no headset could use is refused here.
    static string Describe(string robot)
    {
        RobotFiles.Load(robot, out var urdf);
        return urdf;
    }
}
