using System.Globalization;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Inserts and replaces values in the text of a manifest. All other characters stay unchanged.</summary>
    sealed class ManifestText
    {
        readonly string _file;

        /// <param name="file">Name of the file in messages.</param>
        /// <exception cref="InputException">The text is not a JSON object.</exception>
        public ManifestText(string text, string file)
        {
            _file = file;
            Set(text);
        }

        public string Text { get; private set; }
        public JsonOutline Root { get; private set; }

        /// <summary>Returns the file name and the line number of a value, with which a message starts.</summary>
        public string PlaceOf(JsonOutline value) =>
            _file + ":" + JsonOutlineReader.LineOf(Text, value.ItemStart).ToString(CultureInfo.InvariantCulture);

        /// <summary>Adds a member at the end of the root object.</summary>
        public void Add(string name, JToken value) => Add(Root, name, value);

        /// <summary>Adds an item at the end of an object or array. Outlines that were read before become invalid.</summary>
        /// <param name="container">An object or an array in this manifest.</param>
        /// <param name="name">Name of the new member of an object; null for an array.</param>
        public void Add(JsonOutline container, string name, JToken value)
        {
            var style = new JsonStyle(Text, Root);
            if (container.Items.Count == 0)
            {
                var outer = style.IndentAt(container.Start);
                var inside = style.Padded(outer, style.Item(name, value, outer + style.Indent));
                Set(Text.Substring(0, container.Start + 1) + inside + Text.Substring(container.End - 1));
                return;
            }
            var last = container.Items[container.Items.Count - 1];
            var gap = style.GapBefore(container, last);
            var indent = gap.Substring(gap.LastIndexOf('\n') + 1);
            Set(Text.Insert(last.End, "," + gap + style.Item(name, value, gap.Contains('\n') ? indent : style.IndentAt(last.Start))));
        }

        /// <summary>Replaces a value with a string. Outlines that were read before become invalid.</summary>
        public void Replace(JsonOutline value, string text) =>
            Set(Text.Substring(0, value.Start) + JsonConvert.ToString(text) + Text.Substring(value.End));

        /// <summary>Returns a member of the root object, which must be an object or an array; null if no member of this name exists.</summary>
        /// <param name="isObject">Whether the member must be an object; otherwise it must be an array.</param>
        /// <exception cref="InputException">The member has another type.</exception>
        public JsonOutline Find(string name, bool isObject)
        {
            var found = Root[name];
            if (found == null) return null;
            if (isObject ? found.IsObject : found.IsArray) return found;
            throw new InputException(ManifestMessages.NotAContainer(PlaceOf(found), name, isObject));
        }

        void Set(string text)
        {
            Root = JsonOutlineReader.Read(text, _file);
            Text = text;
        }
    }
}
