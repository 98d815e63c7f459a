using System.Net;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Pairing;

/// <summary>The page that shows the code and prints markers, and what it asks for. For browsers on this machine, and those of operators.</summary>
/// <remarks>
/// Who can open it can pair a headset. From elsewhere an operator logs in on the page of operations first; or the page comes through
/// a tunnel of somebody who may log in here, or the verb "pair" shows the code on a terminal.
/// </remarks>
/// <param name="html">Null where it was not built.</param>
sealed class PairingPage(GatewayOptions options, ShownCode shown, Door door, string html)
{
    readonly HtmlPage _page = new(html);

    /// <summary>Of both servers, once they are known.</summary>
    public int SyncPort { get; set; }

    /// <inheritdoc cref="SyncPort"/>
    public int WebSocketPort { get; set; }

    public bool IsBuilt => _page.IsBuilt;

    CertificatePin Pin => options.Certificate == null ? null : CertificatePin.Of(options.Certificate);

    /// <summary>GET /pair.</summary>
    public async Task ShowAsync(HttpContext context)
    {
        if (await AdmitAsync(context)) await _page.SendAsync(context);
    }

    /// <summary>POST /pair/code: {"renew": ""} for another one.</summary>
    public async Task TellCodeAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (request.ContainsKey("renew")) shown.Discard();
        var code = shown.Current(out var left);
        await SmallJson.AnswerAsync(context, new { text = code.Text, left_s = left.TotalSeconds, key = code.Pin?.Beginning ?? "" });
    }

    /// <summary>POST /pair/cell: the marker's code of name, host, offset and size_mm; with nothing what to begin with.</summary>
    public async Task TellCellAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (!request.ContainsKey("name"))
            await SmallJson.AnswerAsync(context, new { name = options.Cell ?? "", hosts = Hosts(), has_pin = Pin != null });
        else
            await AnswerCellAsync(context, request);
    }

    Task AnswerCellAsync(HttpContext context, Dictionary<string, string> request)
    {
        string Field(string name) => request.GetValueOrDefault(name, "").Trim();
        try
        {
            var offset = Field("offset");
            if (!MarkerOffset.TryReadNumber(Field("size_mm"), out var sizeMm) || sizeMm <= 0)
                throw new InputException($"marker size: '{Field("size_mm")}' is no size; allowed are 10 to 999 mm");
            var code = new CellCode(
                Field("name"), Field("host"), Pin, offset.Length == 0 ? null : MarkerOffset.Parse(offset, "marker offset"), sizeMm / 1000,
                SyncPort, WebSocketPort);
            return SmallJson.AnswerAsync(context, new { text = code.Text });
        }
        catch (InputException fault)
        {
            return SmallJson.AnswerAsync(context, new { fault = fault.Message });
        }
    }

    // Behind a plain gateway there is nobody but this machine.
    string[] Hosts() => options.Certificate == null
        ? ["localhost"] : [.. OwnHosts.Reachable(options.Bind).Select(host => host.Trim('[', ']'))];

    async Task<bool> AdmitAsync(HttpContext context)
    {
        if (!await door.AdmitOriginAsync(context)) return false;
        // A page whose name was made to point here (DNS rebinding) would read along: it comes with its own name.
        if (IsFromThisMachine(context.Connection) && door.IsOwnHost(context)) return true;
        // An operator's cookie or header does not come with such a name.
        if (door.IsOperator(context)) return true;
        await Door.AnswerAsync(
            context, StatusCodes.Status403Forbidden,
            "the page of pairing is for browsers on the gateway's own machine, by its address, its name or localhost, and for operators who logged in");
        return false;
    }

    // Nobody else gets an answer to an address that is this machine's own.
    static bool IsFromThisMachine(ConnectionInfo connection) =>
        IPAddress.IsLoopback(connection.RemoteIpAddress) || connection.RemoteIpAddress.Equals(connection.LocalIpAddress);
}
