using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>A value of a JSON text, and where in the text it stands.</summary>
    sealed class JsonOutline
    {
        /// <summary>The name of a member of an object; null elsewhere.</summary>
        public string Name { get; set; }

        /// <summary>Index of the first character, that of the name where there is one.</summary>
        public int ItemStart { get; set; }

        /// <summary>Index of the first character of the value.</summary>
        public int Start { get; set; }

        /// <summary>Index behind the last character.</summary>
        public int End { get; set; }

        /// <summary>The decoded text of a string; null for every other value.</summary>
        public string Text { get; set; }

        /// <summary>Members of an object or values of an array, in their order; null for every other value.</summary>
        public List<JsonOutline> Items { get; set; }

        public bool IsObject { get; set; }
        public bool IsArray => Items != null && !IsObject;

        public JsonOutline this[string name] => IsObject ? Items.FirstOrDefault(item => item.Name == name) : null;
    }
}
