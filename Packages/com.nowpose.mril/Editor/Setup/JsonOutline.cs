using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>A value of a JSON text and its position in the text.</summary>
    sealed class JsonOutline
    {
        /// <summary>Name of an object's member; null for other values.</summary>
        public string Name { get; set; }

        /// <summary>Index of the first character; for a member, that of the name.</summary>
        public int ItemStart { get; set; }

        /// <summary>Index of the first character of the value.</summary>
        public int Start { get; set; }

        /// <summary>Index after the last character.</summary>
        public int End { get; set; }

        /// <summary>The decoded text of a string; null for every other value.</summary>
        public string Text { get; set; }

        /// <summary>Members of an object or values of an array, in the order of the text; null for every other value.</summary>
        public List<JsonOutline> Items { get; set; }

        public bool IsObject { get; set; }
        public bool IsArray => Items != null && !IsObject;

        public JsonOutline this[string name] => IsObject ? Items.FirstOrDefault(item => item.Name == name) : null;
    }
}
