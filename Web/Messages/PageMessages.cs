using System.Text.Json;

namespace Nowpose.Web.Messages;

/// <summary>Error messages about the data of a page. Each states the allowed form.</summary>
static class PageMessages
{
    public static string NotJson(string reason) => $"the page's data is not JSON, but must be a JSON object: {reason}";
    public static string NotAnObject(JsonValueKind kind) => $"the page's data is a JSON {kind}; it must be an object";
}
