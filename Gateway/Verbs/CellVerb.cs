using System.CommandLine;
using System.Globalization;
using System.Net;
using Nowpose.Gateway.Codes;
using Nowpose.Gateway.Options;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Verbs;

/// <summary>The command "cell", which creates the code of a robot's marker for printing.</summary>
static class CellVerb
{
    const int PixelsPerModule = 20;

    public static Command Create()
    {
        var cell = new Option<string>("--cell") { Description = "Name of the cell", HelpName = "NAME", Required = true };
        var host = new Option<string>("--host") { Description = "Host name or address at which headsets reach the gateway", HelpName = "HOST", Required = true };
        var pin = new PinArguments();
        var offset = TextOption.Create(
            "--offset", "Pose of the marker in the robot's base frame, metres and degrees; without it the code does not contain the base's position",
            "X,Y,Z[,ROLL,PITCH,YAW]");
        var size = NumberOption.Create(
            "--size-mm", "Side length of the printed code without its white margin", 120.0, CellCode.MinSizeMetres * 1000,
            CellCode.MaxSizeMetres * 1000, "mm");
        var sync = NumberOption.Create("--sync-port", "TCP port of the clock synchronisation", ProtocolLimits.SyncPort, 1, IPEndPoint.MaxPort, "");
        var socket = NumberOption.Create("--ws-port", "TCP port of the WebSocket", ProtocolLimits.WebSocketPort, 1, IPEndPoint.MaxPort, "");
        var file = TextOption.Create("--out", "File for the code, .svg at its true size or .png [default: the terminal]", "FILE");
        var command = new Command("cell", "Create the code of a robot's marker with the cell, the gateway and the marker's pose; it contains no secret")
        {
            cell, host, offset, size, sync, socket, file,
        };
        pin.AddTo(command);
        command.SetAction(async (parsed, cancel) =>
        {
            var place = parsed.GetValue(offset);
            var sizeMm = parsed.GetValue(size);
            var key = await Invocation.ReadAsync(() => pin.Read(parsed), cancel);
            var code = new CellCode(
                parsed.GetValue(cell), parsed.GetValue(host), key, place == null ? null : MarkerOffset.Parse(place, "--offset"),
                sizeMm / 1000, parsed.GetValue(sync), parsed.GetValue(socket));
            Draw(code, sizeMm, parsed.GetValue(file));
        });
        return command;
    }

    static void Draw(CellCode code, double sizeMm, string path)
    {
        using var drawn = new QrCode(code.Text);
        if (path == null)
            Console.Out.Write(drawn.Blocks(!Console.IsOutputRedirected));
        else
            Save(path, drawn, sizeMm, code.Cell);
        Console.Out.WriteLine("code " + code.Text);
        Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"modules {drawn.Modules}"));
        Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"edge_mm {sizeMm}"));
        if (path != null)
            Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"edge_with_margin_mm {sizeMm * drawn.Edge / drawn.Modules:0.###}"));
    }

    static void Save(string path, QrCode drawn, double sizeMm, string caption)
    {
        var isPng = path.EndsWith(".png", StringComparison.OrdinalIgnoreCase);
        if (!isPng && !path.EndsWith(".svg", StringComparison.OrdinalIgnoreCase))
            throw new InputException(VerbMessages.OutName(path));
        FileFault.Report(
            () =>
            {
                if (isPng) OutputFile.Write(path, (Stream file) => file.Write(drawn.Png(PixelsPerModule)));
                else OutputFile.Write(path, drawn.Svg(sizeMm, caption));
            },
            e => PathMessages.NotWritten($"--out {path}", e));
    }
}
