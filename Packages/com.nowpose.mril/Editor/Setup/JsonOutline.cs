using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>A value in a JSON document, with its position in the document.</summary>
    sealed class JsonOutline
    {
        /// <summary>Name of the value if it is a member of an object; otherwise null.</summary>
        public string Name { get; set; }

        /// <summary>
        /// Index of the first character of the item. For a member of an object, this is the start of its name; otherwise, it is the start of the
        /// value.
        /// </summary>
        public int ItemStart { get; set; }

        /// <summary>Index of the first character of the value.</summary>
        public int Start { get; set; }

        /// <summary>Index after the last character of the value.</summary>
        public int End { get; set; }

        /// <summary>Decoded text if the value is a string; otherwise null.</summary>
        public string Text { get; set; }

        /// <summary>Members of an object, or elements of an array, in their original order; null for other values.</summary>
        public List<JsonOutline> Items { get; set; }

        public bool IsObject { get; set; }
        public bool IsArray => Items != null && !IsObject;

        public JsonOutline this[string name] => IsObject ? Items.FirstOrDefault(item => item.Name == name) : null;
    }
}
