using System.Globalization;
using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Codes;

/// <summary>The control clock as a code for cameras: a page for a monitor in the place of LEDs, and the time it asks for.</summary>
/// <remarks>
/// The page tells nothing and needs no token, for a browser that opens it has none to send; the time needs one where there are tokens. It
/// is asked for by POST, with which browsers always say what page asks.
/// </remarks>
/// <param name="html">Null where it was not built.</param>
sealed class CodePage(GatewayOptions options, IControlClock clock, Door door, ConnectionCounters counters, Action<string> log, string html)
{
    public const string Path = "/vlc";
    const string TimePath = "/vlc/time";

    readonly HtmlPage _page = new(html);
    readonly TimePlaces _places = new(options, counters, log);

    public bool IsBuilt => _page.IsBuilt;

    /// <summary>Answers its own requests and hands on the others, WebSockets on every path.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        // First of all: what comes in between would count as the way to here.
        var received = clock.Now;
        var isSocket = context.Request.Headers.Upgrade.Count > 0;
        if (!isSocket && context.Request.Path == TimePath) return TellTimeAsync(context, received);
        return !isSocket && context.Request.Path == Path ? ShowAsync(context) : next(context);
    }

    async Task ShowAsync(HttpContext context)
    {
        if (!await door.AdmitOriginAsync(context)) return;
        if (!HttpMethods.IsGet(context.Request.Method)) await Door.RefuseMethodAsync(context, "GET");
        else await SendPageAsync(context);
    }

    Task SendPageAsync(HttpContext context)
    {
        // A page that shares its process with no other is given a finer clock by browsers.
        context.Response.Headers["Cross-Origin-Opener-Policy"] = "same-origin";
        context.Response.Headers["Cross-Origin-Embedder-Policy"] = "require-corp";
        return _page.SendAsync(context);
    }

    async Task TellTimeAsync(HttpContext context, ControlTime received)
    {
        if (await door.AdmitAsync(context) == null) return;
        if (!HttpMethods.IsPost(context.Request.Method))
        {
            await Door.RefuseMethodAsync(context, "POST");
            return;
        }
        if (!await _places.AdmitAsync(context)) return;
        context.Response.ContentType = "application/json";
        context.Response.Headers.CacheControl = "no-store";
        var answer = TimeText(received);
        context.Response.ContentLength = answer.Length;
        await context.Response.Body.WriteAsync(answer);
    }

    // As strings: a browser's numbers do not hold nanoseconds since 1970.
    byte[] TimeText(ControlTime received)
    {
        var stepNs = clock.Resolution.Ticks * TimeSpan.NanosecondsPerTick;
        var isSynchronised = clock.IsSynchronised ? "true" : "false";
        FormattableString text = $$"""
            {"t2_ns":"{{received.Nanoseconds}}","resolution_ns":{{stepNs}},"is_synchronised":{{isSynchronised}},"t3_ns":"{{clock.Now.Nanoseconds}}"}
            """;
        return Encoding.UTF8.GetBytes(text.ToString(CultureInfo.InvariantCulture));
    }
}
